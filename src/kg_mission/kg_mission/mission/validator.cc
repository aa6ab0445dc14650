#include "kg_mission/mission/validator.h"

#include <algorithm>
#include <memory>

#include "kg_core/rdf/namespaces.h"
#include "kg_core/rules/facts_and_conclusions.h"
#include "kg_core/shacl/changes.h"
#include "kg_core/shacl/shape_cache.h"
#include "kg_core/shacl/validation.h"

namespace kg_mission {
namespace {

using kg_core::GraphView;
using kg_core::Violation;

kg_core::shacl::DataGraph GetFacts(const GraphView& view) {
  return {view,
          kg_core::kFactsGraph,
          {kg_core::kFactsGraph, kg_core::kVocabGraph, kg_core::kProvGraph},
          nullptr};
}

// Process-wide cache: a process has one vocabulary, rarely two.
std::shared_ptr<const kg_core::shacl::ShapeGraph> GetShapes(
    const GraphView& view) {
  static kg_core::shacl::ShapeCache* const cache =
      new kg_core::shacl::ShapeCache;
  return cache->Get(view, kg_core::kVocabGraph);
}

bool TouchesVocabulary(const std::vector<kg_core::Statement>& statements) {
  return std::any_of(statements.begin(), statements.end(),
                     [](const kg_core::Statement& s) {
                       return s.graph.text == kg_core::kVocabGraph;
                     });
}

}  // namespace

std::vector<Violation> Validate(const GraphView& view) {
  const auto shapes = GetShapes(view);
  const kg_core::shacl::DataGraph data = GetFacts(view);
  return kg_core::shacl::ShapeValidation(data, *shapes).Run();
}

std::vector<Violation> ValidateChange(const kg_core::Transaction& transaction) {
  const GraphView& view = transaction.view();
  const kg_core::shacl::GraphChange change = {transaction.added(),
                                              transaction.removed()};
  if (TouchesVocabulary(change.added) || TouchesVocabulary(change.removed)) {
    return Validate(view);
  }
  const auto shapes = GetShapes(view);
  return kg_core::shacl::ValidateTouched(GetFacts(view), *shapes, change);
}

std::vector<Violation> ValidateConclusions(const GraphView& view) {
  const kg_core::shacl::GraphChange change = {kg_core::Conclusions(view), {}};
  if (change.added.empty()) return {};
  const auto shapes = GetShapes(view);
  const kg_core::FactsAndConclusions world(view);
  return kg_core::shacl::ValidateTouched(GetFacts(world), *shapes, change);
}

}  // namespace kg_mission
