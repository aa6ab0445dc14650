// A stage in the form used by the searches of micro_paths.h: checked, with legs
// sorted and indexed by (from, to).

#ifndef KG_PLANNER_TOURS_MICRO_GRAPH_H_
#define KG_PLANNER_TOURS_MICRO_GRAPH_H_

#include <cstddef>
#include <vector>

#include "kg_planner/tours/micro_problem.h"

namespace kg_planner {

class MicroGraph {
 public:
  // Throws std::invalid_argument as FindMicroPaths does.
  explicit MicroGraph(const StageProblem& problem);

  int size() const { return static_cast<int>(nodes_.size()); }
  double duration_limit() const { return duration_limit_; }
  // Legs out of a node (-1 = the entry), in the order of their ends.
  const Leg* begin(int from) const { return legs_.data() + first_[from + 1]; }
  const Leg* end(int from) const { return legs_.data() + first_[from + 2]; }
  const Leg* Find(int from, int to) const;  // nullptr = none.

  // Total reward of a set of nodes (ascending); each token once.
  double TotalReward(const std::vector<int>& set) const;
  // The path through `nodes`; empty if a leg is missing or the duration limit
  // is exceeded.
  MicroPath Walk(const std::vector<int>& nodes) const;

 private:
  std::vector<Node> nodes_;
  std::vector<Leg> legs_;           // Sorted by (from, to).
  std::vector<std::size_t> first_;  // Index into legs_, by from + 1.
  double duration_limit_ = 0.0;
  bool has_tokens_ = false;
};

// Whether `a` is preferred to `b`, which visits the same set and ends at the
// same node.
bool BetterOrder(const MicroPath& a, const MicroPath& b);

}  // namespace kg_planner

#endif  // KG_PLANNER_TOURS_MICRO_GRAPH_H_
