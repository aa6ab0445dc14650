#include "kg_core/rules/inference.h"

#include <algorithm>
#include <cstddef>
#include <tuple>

#include "absl/container/flat_hash_set.h"
#include "kg_base/common/input_error.h"
#include "kg_core/facts/terms.h"
#include "kg_core/facts/vocabulary.h"
#include "kg_core/rules/rule.h"

namespace kg_core {
namespace {

bool IsWorld(const Statement& statement) {
  return statement.graph.text == kFactsGraph ||
         statement.graph.text == kVocabGraph;
}

// The changes of a transaction to facts and vocabulary.
std::vector<Statement> CollectWorldChanges(const Transaction& transaction) {
  std::vector<Statement> changes;
  for (auto& statements : {transaction.added(), transaction.removed()}) {
    std::copy_if(statements.begin(), statements.end(),
                 std::back_inserter(changes), IsWorld);
  }
  return changes;
}

// True if the changes may affect the set of rules or the terms they use.
bool ChangesRules(const std::vector<Statement>& changes) {
  return std::any_of(changes.begin(), changes.end(), [](const Statement& s) {
    return s.graph.text == kVocabGraph || DefinesRules(s);
  });
}

bool IsRead(const std::vector<Statement>& changes, const Rule& rule) {
  for (const auto* kinds : {&rule.reads, &rule.negative_reads}) {
    for (const TripleKind& kind : *kinds) {
      for (const Statement& change : changes) {
        if (Includes(kind, change)) return true;
      }
    }
  }
  return false;
}

// Updates the inferred graph to hold exactly the given inferences.
class InferenceWriter {
 public:
  explicit InferenceWriter(Transaction& transaction)
      : transaction_(transaction) {
    const GraphView& view = transaction.view();
    graph_ = view.Find(Iri(kInferredGraph));
    if (graph_ == kNoTerm) return;
    view.Match({kNoTerm, kNoTerm, kNoTerm, graph_}, [this](const Quad& quad) {
      left_.insert({quad.subject, quad.predicate, quad.object});
      return true;
    });
  }

  void Write(const std::vector<Inference>& inferences) {
    for (const Inference& inference : inferences) {
      for (Statement& statement : CollectStatements(inference)) {
        Want(std::move(statement));
      }
    }
    const GraphView& view = transaction_.view();
    std::vector<Statement> removed;
    for (const auto& [subject, predicate, object] : left_) {
      removed.push_back({view.Get(subject), view.Get(predicate),
                         view.Get(object), Iri(kInferredGraph)});
    }
    for (const Statement& statement : removed) transaction_.Remove(statement);
    for (const Statement& statement : added_) transaction_.Add(statement);
  }
  std::size_t added() const { return added_.size(); }

 private:
  using Ids = std::tuple<TermId, TermId, TermId>;

  void Want(Statement statement) {
    const GraphView& view = transaction_.view();
    const Ids ids = {view.Find(statement.subject),
                     view.Find(statement.predicate),
                     view.Find(statement.object)};
    const auto [subject, predicate, object] = ids;
    const bool known =
        subject != kNoTerm && predicate != kNoTerm && object != kNoTerm;
    if (known && (left_.erase(ids) > 0 || kept_.count(ids) > 0)) {
      kept_.insert(ids);
      return;
    }
    added_.push_back(std::move(statement));
  }

  Transaction& transaction_;
  TermId graph_ = kNoTerm;
  absl::flat_hash_set<Ids> left_;
  absl::flat_hash_set<Ids> kept_;
  std::vector<Statement> added_;
};

std::size_t CountStatements(const std::vector<Inference>& inferences) {
  std::size_t count = 0;
  for (const Inference& inference : inferences) {
    count += 9 + 5 * inference.premises.size();
  }
  return count;
}

void Infer(const std::vector<Rule>& rules, ForbiddenTerm forbidden,
           const InferenceLimits& limits, Transaction& transaction) {
  const std::vector<Inference> inferences =
      RunRules(rules, transaction.view(), limits);
  if (CountStatements(inferences) > limits.statements) {
    throw kg_base::InputError(
        "the rules conclude, with reasons, more statements than "
        "the limit of " +
        std::to_string(limits.statements));
  }
  for (const Inference& inference : inferences) {
    CheckConclusion(inference, forbidden);
  }
  InferenceWriter(transaction).Write(inferences);
}

}  // namespace

std::vector<std::string> StageInferences(Transaction& transaction,
                                         ForbiddenTerm forbidden,
                                         const InferenceLimits& limits) {
  const std::vector<Statement> changes = CollectWorldChanges(transaction);
  if (changes.empty()) return {};
  std::vector<std::string> reasons;
  const std::vector<Rule> rules = LoadRules(transaction.view(), &reasons);
  // All rules are checked if rules or vocabulary changed; otherwise they have
  // been checked before.
  const bool others = ChangesRules(changes);
  if (others) {
    CheckWritten(rules, Vocabulary(transaction.view()), forbidden, &reasons);
  }
  if (!reasons.empty()) return reasons;
  const bool is_due =
      others || std::any_of(rules.begin(), rules.end(), [&](const Rule& rule) {
        return IsRead(changes, rule);
      });
  if (!is_due) return {};
  try {
    Infer(rules, forbidden, limits, transaction);
  } catch (const kg_base::InputError& error) {
    return {error.what()};
  }
  return {};
}

}  // namespace kg_core
