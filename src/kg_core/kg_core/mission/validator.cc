#include "kg_core/mission/validator.h"

#include <algorithm>
#include <memory>

#include "kg_core/rdf/namespaces.h"
#include "kg_core/rules/facts_and_conclusions.h"
#include "kg_core/shacl/changes.h"
#include "kg_core/shacl/shape_cache.h"
#include "kg_core/shacl/validation.h"

namespace kg_core {
namespace {

shacl::DataGraph GetFacts(const GraphView& view) {
  return {view, kFactsGraph, {kFactsGraph, kVocabGraph, kProvGraph}, nullptr};
}

// One for all: a process has one vocabulary, rarely two.
std::shared_ptr<const shacl::ShapeGraph> GetShapes(const GraphView& view) {
  static shacl::ShapeCache* const cache = new shacl::ShapeCache;
  return cache->Get(view, kVocabGraph);
}

bool TouchesVocabulary(const std::vector<Statement>& statements) {
  return std::any_of(
      statements.begin(), statements.end(),
      [](const Statement& s) { return s.graph.text == kVocabGraph; });
}

}  // namespace

std::vector<Violation> Validate(const GraphView& view) {
  const auto shapes = GetShapes(view);
  const shacl::DataGraph data = GetFacts(view);
  return shacl::ShapeValidation(data, *shapes).Run();
}

std::vector<Violation> ValidateGraph(const GraphView& view,
                                     const std::string& graph) {
  const auto shapes = GetShapes(view);
  shacl::DataGraph data = GetFacts(view);
  data.graph = graph;
  data.class_graphs.push_back(graph);
  return shacl::ShapeValidation(data, *shapes).Run();
}

std::vector<Violation> ValidateChange(const Transaction& transaction) {
  const GraphView& view = transaction.view();
  const shacl::GraphChange change = {transaction.added(),
                                     transaction.removed()};
  if (TouchesVocabulary(change.added) || TouchesVocabulary(change.removed)) {
    return Validate(view);
  }
  const auto shapes = GetShapes(view);
  return shacl::ValidateTouched(GetFacts(view), *shapes, change);
}

std::vector<Violation> ValidateConclusions(const GraphView& view) {
  const shacl::GraphChange change = {Conclusions(view), {}};
  if (change.added.empty()) return {};
  const auto shapes = GetShapes(view);
  const FactsAndConclusions world(view);
  return shacl::ValidateTouched(GetFacts(world), *shapes, change);
}

}  // namespace kg_core
