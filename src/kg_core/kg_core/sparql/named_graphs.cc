// Selection of the named graphs that GRAPH has to evaluate.

#include <algorithm>

#include "kg_core/sparql/evaluator.h"

namespace kg_core::sparql {
namespace {

using PatternKind = GraphPattern::Kind;

// A triple pattern with a constant that every solution of `pattern` must match;
// nullptr if none is found.
const TriplePattern* Anchor(const GraphPattern& pattern) {
  switch (pattern.kind) {
    case PatternKind::kBasic:
      for (const TriplePattern& triple : pattern.triples) {
        // A triple with a constant narrows down the graphs that can match.
        const bool constant = !triple.subject.is_variable ||
                              !triple.object.is_variable ||
                              !triple.predicate.is_variable;
        if (!triple.path && constant) return &triple;
      }
      return nullptr;
    case PatternKind::kJoin:
    case PatternKind::kLeftJoin:
    case PatternKind::kFilter:
    case PatternKind::kMinus:
    case PatternKind::kExtend:
      return Anchor(pattern.parts[0]);
    case PatternKind::kUnion:
    case PatternKind::kGraph:
    case PatternKind::kValues:
    case PatternKind::kSelect:
      break;
  }
  return nullptr;
}

// The graphs of the matching quads, by a scan of these quads.
std::vector<TermId> GraphsOfMatches(const GraphView& view, const Quad& pattern,
                                    QueryBudget* budget) {
  std::vector<TermId> graphs;
  view.Match(pattern, [&](const Quad& quad) {
    budget->Step();
    graphs.push_back(quad.graph);
    return true;
  });
  std::sort(graphs.begin(), graphs.end());
  graphs.erase(std::unique(graphs.begin(), graphs.end()), graphs.end());
  return graphs;
}

// The graphs that may have a matching quad, by one index look-up per graph.
std::vector<TermId> GraphsWith(const GraphView& view, Quad pattern,
                               QueryBudget* budget) {
  std::vector<TermId> graphs;
  for (const TermId graph : view.Graphs()) {
    budget->Step();
    pattern.graph = graph;
    if (view.Estimate(pattern) > 0) graphs.push_back(graph);
  }
  return graphs;
}

}  // namespace

// The graph named `graph`; nullptr if the dataset has no such graph.
const ActiveGraph* PatternEvaluator::NamedGraph(TermId graph) {
  const auto known = graphs_.find(graph);
  if (known != graphs_.end()) return known->second.get();
  auto active = std::make_unique<ActiveGraph>(
      &terms_->view(), std::vector<TermId>{graph}, budget_);
  const bool there = dataset_.named_graphs
                         ? std::find(dataset_.named_graphs->begin(),
                                     dataset_.named_graphs->end(),
                                     graph) != dataset_.named_graphs->end()
                         : graph != dataset_.unnamed_graph && !active->empty();
  if (!there) active.reset();
  return (graphs_[graph] = std::move(active)).get();
}

// The graphs that may have solutions of `p`, found by a look-up per graph or,
// if cheaper, by a scan of the quads that match the anchor.
std::vector<TermId> PatternEvaluator::CandidateGraphs(const GraphPattern& p,
                                                      const Row& row) {
  if (dataset_.named_graphs) return *dataset_.named_graphs;
  Quad quad;
  const TriplePattern* anchor = p.materialise ? nullptr : Anchor(p);
  if (anchor != nullptr) {
    quad.subject = GetValue(anchor->subject, row);
    quad.predicate = GetValue(anchor->predicate, row);
    quad.object = GetValue(anchor->object, row);
  }
  // A term unknown to the store occurs in no quad.
  if (TermTable::IsLocal(quad.subject) || TermTable::IsLocal(quad.predicate) ||
      TermTable::IsLocal(quad.object)) {
    return {};
  }
  // With few matches, scanning them is cheaper than one index look-up per
  // graph.
  constexpr std::size_t kFewQuads = 32;
  const GraphView& view = terms_->view();
  std::vector<TermId> graphs = view.Estimate(quad) <= kFewQuads
                                   ? GraphsOfMatches(view, quad, budget_)
                                   : GraphsWith(view, quad, budget_);
  const auto unnamed =
      std::find(graphs.begin(), graphs.end(), dataset_.unnamed_graph);
  if (unnamed != graphs.end()) graphs.erase(unnamed);
  return graphs;
}

}  // namespace kg_core::sparql
