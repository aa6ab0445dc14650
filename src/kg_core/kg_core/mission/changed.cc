#include "kg_core/mission/changed.h"

#include <vector>

#include "kg_core/mission/terms.h"

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

}  // namespace

std::set<Term> ChangedSubjects(const Transaction& transaction) {
  return Collect(transaction, nullptr);
}

std::set<Term> ChangedSubjects(const Transaction& transaction,
                               const Term& property) {
  return Collect(transaction, &property);
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
