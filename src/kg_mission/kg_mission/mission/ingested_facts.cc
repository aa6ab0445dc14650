#include "kg_mission/mission/ingested_facts.h"

#include <algorithm>
#include <set>

#include "kg_core/facts/terms.h"
#include "kg_mission/mission/layer_reader.h"

namespace kg_mission {
namespace {

using kg_core::Ex;
using kg_core::Facts;
using kg_core::GraphView;
using kg_core::Has;
using kg_core::RdfType;
using kg_core::Statement;
using kg_core::Term;

bool IsDataSource(const GraphView& view, const Term& subject) {
  return Has(view, kg_core::kFactsGraph, subject, RdfType(), Ex("DataSource"));
}

// True if the subject is a prior layer or constraint with a raster in a file.
// For a removed subject the class is no longer known.
bool NamesAFile(const GraphView& view, const Statement& grid_ref) {
  return grid_ref.object != kg_core::Literal(kLandRef) &&
         !Has(view, kg_core::kFactsGraph, grid_ref.subject, RdfType(),
              Ex("ValueLayer")) &&
         !Has(view, kg_core::kFactsGraph, grid_ref.subject, RdfType(),
              Ex("CostField"));
}

bool HasRaster(const GraphView& view, const Term& subject) {
  const auto ref =
      kg_core::FirstObject(view, kg_core::kFactsGraph, subject, Ex("gridRef"));
  return ref && NamesAFile(view, {subject, Ex("gridRef"), *ref, Facts()});
}

// True for properties that data sources share with other classes.
bool IsOfASource(const Term& property) {
  return property == Ex("kind") || property == Ex("resampling") ||
         property == Ex("fullScale") || property == Ex("frontFullScale");
}

bool Matters(const Statement& statement, const GraphView& view) {
  if (statement.graph != Facts()) return false;
  const Term& property = statement.predicate;
  if (IngestReads(property)) return true;
  if (property == RdfType()) return statement.object == Ex("DataSource");
  if (property == Ex("gridRef")) return NamesAFile(view, statement);
  if (!IsOfASource(property)) return false;
  return IsDataSource(view, statement.subject) ||
         (property == Ex("resampling") && HasRaster(view, statement.subject));
}

}  // namespace

bool IngestReads(const Term& property) {
  static const std::set<Term> kMatters = {Ex("file"),
                                          Ex("provides"),
                                          Ex("sampleAbove"),
                                          Ex("index"),
                                          Ex("durationHours"),
                                          Ex("hasWindow"),
                                          Ex("horizon"),
                                          kg_core::TimeTerm("hasBeginning"),
                                          kg_core::TimeTerm("hasEnd")};
  return kMatters.count(property) != 0;
}

bool IngestIsDue(const kg_core::Transaction& transaction) {
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
  kg_core::Quad pattern;
  pattern.predicate = view.Find(Ex("ingestedFrom"));
  pattern.graph = view.Find(Facts());
  if (pattern.predicate == kg_core::kNoTerm ||
      pattern.graph == kg_core::kNoTerm) {
    return subjects;
  }
  view.Match(pattern, [&](const kg_core::Quad& quad) {
    subjects.insert(view.Get(quad.subject));
    return true;
  });
  return subjects;
}

void DropIngestedFacts(kg_core::Transaction& transaction) {
  for (const Term& subject : IngestedSubjects(transaction.view())) {
    transaction.RemoveMatching(&subject, nullptr, nullptr, Facts());
  }
}

}  // namespace kg_mission
