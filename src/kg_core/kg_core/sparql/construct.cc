#include "kg_core/sparql/construct.h"

#include <tuple>
#include <utility>

#include "absl/container/flat_hash_set.h"
#include "kg_core/sparql/fresh_blank.h"

namespace kg_core::sparql {
namespace {

// Collects triples without duplicates.
class TripleSet {
 public:
  explicit TripleSet(const QueryRun& run)
      : terms_(run.terms), budget_(run.budget) {}

  void Add(const Quad& quad) {
    budget_->Step();
    const auto key = std::make_tuple(quad.subject, quad.predicate, quad.object);
    if (!seen_.insert(key).second) return;
    budget_->UseWorkingBytes(4 * sizeof(key));
    const Triple triple{terms_->Get(quad.subject), terms_->Get(quad.predicate),
                        terms_->Get(quad.object)};
    std::size_t bytes = 0;
    for (const Term* term :
         {&triple.subject, &triple.predicate, &triple.object}) {
      bytes +=
          term->text.size() + term->datatype.size() + term->language.size();
    }
    budget_->AddResultRow(bytes);
    triples_.push_back(triple);
  }
  std::vector<Triple> Take() { return std::move(triples_); }

 private:
  TermTable* terms_;
  QueryBudget* budget_;
  absl::flat_hash_set<std::tuple<TermId, TermId, TermId>> seen_;
  std::vector<Triple> triples_;
};

// The resources to describe, each once.
std::vector<TermId> Resources(const QueryRun& run) {
  std::vector<TermId> resources;
  absl::flat_hash_set<TermId> seen;
  const auto add = [&](TermId id) {
    if (id == kNoTerm || run.terms->Get(id).is_literal()) return;
    if (!seen.insert(id).second) return;
    run.budget->UseWorkingBytes(4 * sizeof(TermId));
    resources.push_back(id);
  };
  // First the resources named in the query, then those of its solutions.
  for (const VarOrTerm& node : run.query.describe) {
    if (node.is_variable) continue;
    const auto constant = static_cast<std::size_t>(node.index);
    add(run.terms->Intern(run.query.constants[constant]));
  }
  run.evaluator->Run([&](Row& row) {
    for (const VarOrTerm& node : run.query.describe) {
      if (node.is_variable) add(row[static_cast<std::size_t>(node.index)]);
    }
    return true;
  });
  return resources;
}

}  // namespace

TemplateInstantiator::TemplateInstantiator(const Query* query, TermTable* terms)
    : query_(query), terms_(terms) {
  for (const Term& constant : query->constants) {
    constants_.push_back(terms->Intern(constant));
  }
}

TermId TemplateInstantiator::GetValue(const VarOrTerm& node) {
  if (node.index == kNone) return kNoTerm;
  const auto index = static_cast<std::size_t>(node.index);
  if (!node.is_variable) return constants_[index];
  TermId& slot = row_[index];
  if (slot == kNoTerm && IsHidden(query_->variables[index])) {
    slot = terms_->Intern(FreshBlank());
  }
  return slot;
}

bool TemplateInstantiator::IsRdf(const Quad& quad) const {
  if (quad.subject == kNoTerm || quad.predicate == kNoTerm ||
      quad.object == kNoTerm) {
    return false;
  }
  return !terms_->Get(quad.subject).is_literal() &&
         terms_->Get(quad.predicate).is_iri();
}

void TemplateInstantiator::Run(const std::vector<QuadTemplate>& templates,
                               const Row& solution,
                               absl::FunctionRef<void(const Quad&)> give) {
  row_ = solution;
  for (const QuadTemplate& made : templates) {
    const TriplePattern& triple = made.triple;
    const Quad quad{GetValue(triple.subject), GetValue(triple.predicate),
                    GetValue(triple.object), GetValue(made.graph)};
    const bool named = made.graph.index != kNone;
    const bool has_graph = !named || (quad.graph != kNoTerm &&
                                      !terms_->Get(quad.graph).is_literal());
    if (has_graph && IsRdf(quad)) give(quad);
  }
}

std::vector<Triple> Construct(const QueryRun& run) {
  TripleSet triples(run);
  TemplateInstantiator instantiator(&run.query, run.terms);
  run.evaluator->Run([&](Row& row) {
    instantiator.Run(run.query.construct, row,
                     [&triples](const Quad& quad) { triples.Add(quad); });
    return true;
  });
  return triples.Take();
}

std::vector<Triple> Describe(const QueryRun& run) {
  TripleSet triples(run);
  std::vector<TermId> open = Resources(run);
  absl::flat_hash_set<TermId> seen(open.begin(), open.end());
  while (!open.empty()) {
    const TermId subject = open.back();
    open.pop_back();
    run.evaluator->default_graph().Match(
        {subject, kNoTerm, kNoTerm, kNoTerm}, [&](const Quad& quad) {
          triples.Add(quad);
          if (run.terms->Get(quad.object).is_blank() &&
              seen.insert(quad.object).second) {
            open.push_back(quad.object);
          }
          return true;
        });
  }
  return triples.Take();
}

}  // namespace kg_core::sparql
