#include "kg_core/sparql/active_graph.h"

#include <algorithm>
#include <utility>

#include "absl/container/flat_hash_set.h"

namespace kg_core::sparql {
namespace {

bool IsKnown(const Quad& pattern) {
  return !TermTable::IsLocal(pattern.subject) &&
         !TermTable::IsLocal(pattern.predicate) &&
         !TermTable::IsLocal(pattern.object);
}

}  // namespace

ActiveGraph::ActiveGraph(const GraphView* view, std::vector<TermId> graphs,
                         QueryBudget* budget)
    : view_(view), budget_(budget) {
  for (const TermId graph : graphs) {
    const bool twice =
        std::find(graphs_.begin(), graphs_.end(), graph) != graphs_.end();
    if (!TermTable::IsLocal(graph) && !twice) graphs_.push_back(graph);
  }
}

// True if the triple is also in one of the graphs before `index`, so that it
// has been visited already.
bool ActiveGraph::HasBefore(const Quad& quad, std::size_t index) const {
  for (std::size_t i = 0; i < index; ++i) {
    bool found = false;
    view_->Match({quad.subject, quad.predicate, quad.object, graphs_[i]},
                 [&found](const Quad&) {
                   found = true;
                   return false;
                 });
    if (found) return true;
  }
  return false;
}

bool ActiveGraph::Match(const Quad& pattern,
                        absl::FunctionRef<bool(const Quad&)> visit) const {
  if (!IsKnown(pattern)) return true;
  bool go_on = true;
  for (std::size_t i = 0; i < graphs_.size() && go_on; ++i) {
    view_->Match(
        {pattern.subject, pattern.predicate, pattern.object, graphs_[i]},
        [&](const Quad& quad) {
          budget_->Step();
          if (i > 0 && HasBefore(quad, i)) return true;
          go_on = visit(quad);
          return go_on;
        });
  }
  return go_on;
}

std::size_t ActiveGraph::Estimate(const Quad& pattern) const {
  if (!IsKnown(pattern)) return 0;
  std::size_t sum = 0;
  for (const TermId graph : graphs_) {
    sum += view_->Estimate(
        {pattern.subject, pattern.predicate, pattern.object, graph});
  }
  return sum;
}

std::vector<TermId> ActiveGraph::Nodes() const {
  absl::flat_hash_set<TermId> seen;
  std::vector<TermId> nodes;
  const auto add = [&](TermId node) {
    if (!seen.insert(node).second) return;
    nodes.push_back(node);
    budget_->UseWorkingBytes(2 * sizeof(TermId));
  };
  for (const TermId graph : graphs_) {
    view_->Match({kNoTerm, kNoTerm, kNoTerm, graph}, [&](const Quad& quad) {
      budget_->Step();
      add(quad.subject);
      add(quad.object);
      return true;
    });
  }
  return nodes;
}

bool ActiveGraph::HasMatch(const Quad& pattern) const {
  bool found = false;
  Match(pattern, [&found](const Quad&) {
    found = true;
    return false;
  });
  return found;
}

bool ActiveGraph::HasNode(TermId node) const {
  return HasMatch({node, kNoTerm, kNoTerm, kNoTerm}) ||
         HasMatch({kNoTerm, kNoTerm, node, kNoTerm});
}

bool ActiveGraph::empty() const { return !HasMatch({}); }

}  // namespace kg_core::sparql
