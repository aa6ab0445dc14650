#include "kg_core/rules/fixed_point.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "kg_base/common/input_error.h"
#include "kg_base/common/sha256.h"
#include "kg_base/common/stopwatch.h"
#include "kg_core/facts/terms.h"
#include "kg_core/rules/rule_world.h"
#include "kg_core/rules/strata.h"
#include "kg_core/sparql/budget.h"
#include "kg_core/sparql/construct.h"
#include "kg_core/sparql/evaluator.h"
#include "kg_core/sparql/resolve_dataset.h"
#include "kg_core/sparql/term_table.h"

namespace kg_core {
namespace {

using kg_base::InputError;
using sparql::Row;

// The derivation by one solution of a rule's WHERE, with ids of the RuleWorld.
struct RuleDerivation {
  const Rule* rule = nullptr;
  Quad conclusion;
  std::vector<Quad> premises;
};

std::string XsdNumber(double value) { return DoubleLiteral(value).text; }

// One evaluation of one rule.
class RuleRun {
 public:
  RuleRun(const Rule& rule, RuleWorld* world, const QueryLimits& limits)
      : rule_(rule),
        world_(world),
        budget_(limits),
        terms_(world, &budget_),
        instantiator_(&rule.query, &terms_) {
    for (const sparql::QuadTemplate& made : rule.query.construct) {
      const sparql::TriplePattern& triple = made.triple;
      for (const sparql::VarOrTerm& node :
           {triple.subject, triple.predicate, triple.object}) {
        if (node.is_variable) template_variables_.Insert(node.index);
      }
    }
  }

  std::vector<RuleDerivation> Run() {
    Dataset dataset;
    dataset.default_graphs = {kFactsGraph, kVocabGraph, kInferredGraph};
    dataset.named_graphs.emplace();
    sparql::PatternEvaluator evaluator(
        &rule_.query, &terms_, sparql::Resolve(rule_.query, dataset, &terms_),
        &budget_);
    std::vector<Quad> matched;
    evaluator.Trace(&matched);
    evaluator.Run([&](Row& row) {
      Take(row, matched);
      return true;
    });
    for (RuleDerivation& derivation : found_) Settle(&derivation.conclusion);
    return std::move(found_);
  }

 private:
  void Take(Row row, const std::vector<Quad>& matched) {
    NameBlankNodes(&row);
    instantiator_.Run(rule_.query.construct, row, [&](const Quad& quad) {
      budget_.Step();
      budget_.UseWorkingBytes(sizeof(RuleDerivation) +
                              sizeof(Quad) * matched.size());
      found_.push_back({&rule_, quad, matched});
    });
  }

  void NameBlankNodes(Row* row) {
    int count = 0;
    for (const int variable : template_variables_.Members()) {
      if (!sparql::IsHidden(GetName(variable))) continue;
      Slot(row, variable) = terms_.Intern(MakeNode(*row, count++));
    }
  }

  // The IRI that replaces blank node number `count` of the template.
  Term MakeNode(const Row& row, int count) const {
    kg_base::Hasher hash;
    hash.Add(rule_.iri.text);
    hash.Add(static_cast<double>(count));
    for (const int variable : template_variables_.Members()) {
      if (sparql::IsHidden(GetName(variable))) continue;
      const TermId value = row[static_cast<std::size_t>(variable)];
      hash.Add(GetName(variable));
      hash.Add(value == kNoTerm ? "" : ToNTriples(terms_.Get(value)));
    }
    return Ex("concluded/" + hash.Hex().substr(0, 32));
  }

  const std::string& GetName(int variable) const {
    return rule_.query.variables[static_cast<std::size_t>(variable)];
  }
  static TermId& Slot(Row* row, int variable) {
    return (*row)[static_cast<std::size_t>(variable)];
  }

  // Converts ids of the query to ids of the world, after the query has ended.
  void Settle(Quad* quad) {
    for (TermId Quad::*place :
         {&Quad::subject, &Quad::predicate, &Quad::object}) {
      TermId& id = quad->*place;
      if (sparql::TermTable::IsLocal(id)) id = world_->Intern(terms_.Get(id));
    }
  }

  const Rule& rule_;
  RuleWorld* world_;
  sparql::QueryBudget budget_;
  sparql::TermTable terms_;
  sparql::TemplateInstantiator instantiator_;
  sparql::VariableSet template_variables_;
  std::vector<RuleDerivation> found_;
};

class FixedPoint {
 public:
  FixedPoint(const GraphView& view, const InferenceLimits& limits)
      : world_(view), limits_(limits) {}

  std::vector<Inference> Run(const std::vector<Rule>& rules) {
    for (const Stratum& stratum : Stratify(rules)) Complete(stratum);
    std::vector<Inference> all;
    for (auto& [conclusion, reasons] : reasons_) {
      for (auto& [iri, inference] : reasons) {
        all.push_back(std::move(inference));
      }
    }
    return all;
  }

 private:
  void Complete(const Stratum& stratum) {
    bool is_new = Round(stratum);
    for (int round = 1; is_new && stratum.recursive; ++round) {
      if (round >= limits_.rounds) {
        throw InputError(ToTurtle(stratum.rules.front()->iri) +
                         ": no end after the limit of " +
                         std::to_string(limits_.rounds) + " rounds");
      }
      is_new = Round(stratum);
    }
  }

  // One round: runs all rules on the same state, then adds their conclusions.
  // Returns true if any was new.
  bool Round(const Stratum& stratum) {
    std::vector<RuleDerivation> found;
    for (const Rule* rule : stratum.rules) {
      for (RuleDerivation& derivation : RunRule(*rule)) {
        const bool keep =
            !stratum.recursive || !world_.IsConcluded(derivation.conclusion);
        if (keep) found.push_back(std::move(derivation));
      }
    }
    // Add conclusions only now, so that every rule of the round sees the same
    // statements.
    bool is_new = false;
    for (RuleDerivation& derivation : found) {
      is_new |= world_.Conclude(derivation.conclusion);
      if (world_.size() > limits_.conclusions) {
        throw InputError(ToTurtle(derivation.rule->iri) +
                         ": more conclusions than the limit of " +
                         std::to_string(limits_.conclusions));
      }
      Keep(derivation);
    }
    return is_new;
  }

  std::vector<RuleDerivation> RunRule(const Rule& rule) {
    QueryLimits limits;
    limits.seconds = limits_.seconds - watch_.Elapsed_s();
    limits.working_bytes = limits_.working_bytes;
    try {
      return RuleRun(rule, &world_, limits).Run();
    } catch (const InputError& error) {
      const std::string name = ToTurtle(rule.iri) + ": ";
      if (watch_.Elapsed_s() < limits_.seconds) {
        throw InputError(name + error.what());
      }
      throw InputError(name + "the rules took longer than the limit of " +
                       XsdNumber(limits_.seconds) + " s");
    }
  }

  Triple MakeTriple(const Quad& quad) const {
    return {world_.Get(quad.subject), world_.Get(quad.predicate),
            world_.Get(quad.object)};
  }

  void Keep(const RuleDerivation& derivation) {
    Inference inference;
    inference.rule_iri = derivation.rule->iri.text;
    inference.conclusion = MakeTriple(derivation.conclusion);
    std::map<std::string, Triple> premises;  // By statement IRI.
    for (const Quad& quad : derivation.premises) {
      Triple premise = MakeTriple(quad);
      std::string name = StatementIri(premise);
      premises.emplace(std::move(name), std::move(premise));
    }
    if (premises.size() > limits_.premises) {
      throw InputError(ToTurtle(derivation.rule->iri) +
                       ": a conclusion from more statements than the limit "
                       "of " +
                       std::to_string(limits_.premises));
    }
    for (auto& [name, premise] : premises) {
      inference.premises.push_back(std::move(premise));
    }
    inference.iri = InferenceIri(inference);
    KeepFirst(std::move(inference), derivation.conclusion);
  }

  void KeepFirst(Inference inference, const Quad& conclusion) {
    auto& reasons = reasons_[std::make_pair(
        conclusion.subject,
        std::make_pair(conclusion.predicate, conclusion.object))];
    std::string iri = inference.iri;
    reasons.emplace(std::move(iri), std::move(inference));
    if (reasons.size() > limits_.reasons) {
      reasons.erase(std::prev(reasons.end()));
    }
  }

  using TripleKey = std::pair<TermId, std::pair<TermId, TermId>>;

  RuleWorld world_;
  const InferenceLimits& limits_;
  const kg_base::Stopwatch watch_;
  // By conclusion, then by IRI.
  std::map<TripleKey, std::map<std::string, Inference>> reasons_;
};

}  // namespace

std::vector<Inference> RunRules(const std::vector<Rule>& rules,
                                const GraphView& view,
                                const InferenceLimits& limits) {
  return FixedPoint(view, limits).Run(rules);
}

}  // namespace kg_core
