#include "kg_core/facts/changed_subjects.h"

#include <vector>

#include "kg_core/facts/terms.h"

namespace kg_core {
namespace {

std::set<Term> Collect(const Transaction& transaction, const Term* property) {
  std::set<Term> subjects;
  for (const auto& statements : {transaction.added(), transaction.removed()}) {
    for (const Statement& statement : statements) {
      const bool is_meant =
          property == nullptr || statement.predicate == *property;
      if (is_meant && statement.graph == Facts()) {
        subjects.insert(statement.subject);
      }
    }
  }
  return subjects;
}

std::set<Term> Having(const GraphView& view, const Term& property) {
  std::set<Term> subjects;
  const Quad pattern{kNoTerm, view.Find(property), kNoTerm, view.Find(Facts())};
  if (pattern.predicate == kNoTerm || pattern.graph == kNoTerm) return subjects;
  view.Match(pattern, [&](const Quad& quad) {
    subjects.insert(view.Get(quad.subject));
    return true;
  });
  return subjects;
}

}  // namespace

std::set<Term> ChangedSubjects(const Transaction& transaction) {
  return Collect(transaction, nullptr);
}

std::set<Term> ChangedSubjects(const Transaction& transaction,
                               const Term& property, const ChangeScope scope) {
  std::set<Term> subjects = Collect(transaction, &property);
  if (scope == ChangeScope::kAll) {
    subjects.merge(Having(transaction.view(), property));
  }
  return subjects;
}

std::set<Term> Linked(const Transaction& transaction, const Term& subject,
                      const Term& link) {
  const std::vector<Term> now =
      Objects(transaction.view(), kFactsGraph, subject, link);
  std::set<Term> nodes(now.begin(), now.end());
  for (const Statement& statement : transaction.removed()) {
    const bool is_link = statement.subject == subject &&
                         statement.predicate == link &&
                         statement.graph == Facts();
    if (is_link) nodes.insert(statement.object);
  }
  return nodes;
}

}  // namespace kg_core
