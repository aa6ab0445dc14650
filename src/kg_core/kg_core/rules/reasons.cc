#include "kg_core/rules/reasons.h"

#include <algorithm>
#include <optional>

#include "kg_base/common/sha256.h"
#include "kg_core/facts/terms.h"

namespace kg_core {
namespace {

using kg_base::Hasher;

constexpr std::size_t kNameDigits = 32;  // 128 bits.
constexpr char kStatementFolder[] = "statement/";
constexpr char kInferenceFolder[] = "inference/";

Term RdfTerm(const char* local) { return Iri(std::string(kRdf) + local); }

std::string GetName(const char* folder, const Hasher& hash) {
  return kEx + (folder + hash.Hex().substr(0, kNameDigits));
}

bool LiesIn(const Term& term, const char* folder) {
  const std::string place = std::string(kEx) + folder;
  return term.is_iri() && term.text.compare(0, place.size(), place) == 0;
}

void Describe(const Triple& triple, const Term& node,
              std::vector<Statement>* out) {
  const Term graph = Iri(kInferredGraph);
  out->push_back({node, RdfType(), RdfTerm("Statement"), graph});
  out->push_back({node, RdfTerm("subject"), triple.subject, graph});
  out->push_back({node, RdfTerm("predicate"), triple.predicate, graph});
  out->push_back({node, RdfTerm("object"), triple.object, graph});
}

Triple ReadStatement(const GraphView& view, const Term& node) {
  const auto part = [&](const char* local) {
    return FirstObject(view, kInferredGraph, node, RdfTerm(local))
        .value_or(Term());
  };
  return {part("subject"), part("predicate"), part("object")};
}

Inference ReadInference(const GraphView& view, const Term& node) {
  Inference inference;
  inference.iri = node.text;
  const auto rule = FirstObject(view, kInferredGraph, node, Ex("byRule"));
  if (rule) inference.rule_iri = rule->text;
  std::vector<Term> premises =
      Objects(view, kInferredGraph, node, Prov("wasDerivedFrom"));
  std::sort(premises.begin(), premises.end());
  for (const Term& premise : premises) {
    inference.premises.push_back(ReadStatement(view, premise));
  }
  return inference;
}

}  // namespace

std::string StatementIri(const Triple& triple) {
  Hasher hash;
  hash.Add(ToNTriples(triple.subject));
  hash.Add(ToNTriples(triple.predicate));
  hash.Add(ToNTriples(triple.object));
  return GetName(kStatementFolder, hash);
}

std::string InferenceIri(const Inference& inference) {
  Hasher hash;
  hash.Add(inference.rule_iri);
  hash.Add(StatementIri(inference.conclusion));
  for (const Triple& premise : inference.premises) {
    hash.Add(StatementIri(premise));
  }
  return GetName(kInferenceFolder, hash);
}

bool IsReason(const Term& subject) {
  return LiesIn(subject, kStatementFolder) || LiesIn(subject, kInferenceFolder);
}

std::vector<Statement> CollectStatements(const Inference& inference) {
  const Term graph = Iri(kInferredGraph);
  const Term node = Iri(inference.iri);
  const Term conclusion = Iri(StatementIri(inference.conclusion));
  const Triple& triple = inference.conclusion;
  std::vector<Statement> out = {
      {triple.subject, triple.predicate, triple.object, graph},
      {node, RdfType(), Ex("Inference"), graph},
      {node, Ex("byRule"), Iri(inference.rule_iri), graph},
      {node, Ex("conclusion"), conclusion, graph},
      {conclusion, Prov("wasDerivedFrom"), node, graph}};
  Describe(triple, conclusion, &out);
  for (const Triple& premise : inference.premises) {
    const Term statement = Iri(StatementIri(premise));
    out.push_back({node, Prov("wasDerivedFrom"), statement, graph});
    Describe(premise, statement, &out);
  }
  return out;
}

std::vector<Inference> WhyInferred(const GraphView& view,
                                   const Triple& triple) {
  std::vector<Term> nodes = Subjects(view, kInferredGraph, Ex("conclusion"),
                                     Iri(StatementIri(triple)));
  std::sort(nodes.begin(), nodes.end());
  std::vector<Inference> inferences;
  for (const Term& node : nodes) {
    inferences.push_back(ReadInference(view, node));
    inferences.back().conclusion = triple;
  }
  return inferences;
}

}  // namespace kg_core
