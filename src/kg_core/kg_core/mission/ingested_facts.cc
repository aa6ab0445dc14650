#include "kg_core/mission/ingested_facts.h"

#include <algorithm>
#include <set>

#include "kg_core/mission/ingest.h"
#include "kg_core/mission/terms.h"

namespace kg_core {
namespace {

bool IsDataSource(const GraphView& view, const Term& subject) {
  return Has(view, kFactsGraph, subject, RdfType(), Ex("DataSource"));
}

bool Matters(const Statement& statement, const GraphView& view) {
  if (statement.graph != Facts()) return false;
  if (IngestReads(statement.predicate)) return true;
  if (statement.predicate == RdfType()) {
    return statement.object == Ex("DataSource");
  }
  return statement.predicate == Ex("kind") &&
         IsDataSource(view, statement.subject);
}

}  // namespace

bool IngestReads(const Term& property) {
  static const std::set<Term> kMatters = {Ex("file"),
                                          Ex("provides"),
                                          Ex("index"),
                                          Ex("durationHours"),
                                          Ex("hasWindow"),
                                          Ex("horizon"),
                                          TimeTerm("hasBeginning"),
                                          TimeTerm("hasEnd")};
  return kMatters.count(property) != 0;
}

bool IngestIsDue(const Transaction& transaction) {
  const auto any = [&](const std::vector<Statement>& statements) {
    return std::any_of(statements.begin(), statements.end(),
                       [&](const Statement& statement) {
                         return Matters(statement, transaction.view());
                       });
  };
  return any(transaction.added()) || any(transaction.removed());
}

std::set<Term> IngestedSubjects(const GraphView& view) {
  std::set<Term> subjects;
  Quad pattern;
  pattern.predicate = view.Find(Ex("ingestedFrom"));
  pattern.graph = view.Find(Facts());
  if (pattern.predicate == kNoTerm || pattern.graph == kNoTerm) {
    return subjects;
  }
  view.Match(pattern, [&](const Quad& quad) {
    subjects.insert(view.Get(quad.subject));
    return true;
  });
  return subjects;
}

void DropIngestedFacts(Transaction& transaction) {
  for (const Term& subject : IngestedSubjects(transaction.view())) {
    transaction.RemoveMatching(&subject, nullptr, nullptr, Facts());
  }
}

}  // namespace kg_core
