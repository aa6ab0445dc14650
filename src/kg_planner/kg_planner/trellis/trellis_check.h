// Checks every number of a trellis in one pass, and summarises what the
// searches need: whether seams are sorted, and the largest possible total of a
// path.
//
// Order of ties among seams from one node: by (to, via).

#ifndef KG_PLANNER_TRELLIS_TRELLIS_CHECK_H_
#define KG_PLANNER_TRELLIS_TRELLIS_CHECK_H_

#include <cstddef>
#include <vector>

#include "kg_planner/trellis/trellis.h"

namespace kg_planner {

struct TrellisSummary {
  std::vector<char> sorted;    // By stage: seams ascend by (from, to, via).
  double largest_total = 0.0;  // Upper bound of any partial score.
};

// Nodes a seam visits on the way.
inline const std::vector<int>& NodesVia(const Stage& stage, std::size_t seam) {
  static const std::vector<int> none;
  return stage.via.empty() ? none : stage.via[seam];
}

// Use of resource r, starting with 0.
inline double SeamResource(const Stage& stage, std::size_t seam,
                           std::size_t r) {
  return r == 0 ? stage.seams[seam].resource
                : stage.more_resources[r - 1][seam];
}

// Whether seam a precedes seam b: by (from, to, via).
bool StandsBefore(const Stage& stage, std::size_t a, std::size_t b);

// Number of source nodes of `stage`: 1 for the first stage.
int NodesBefore(const Trellis& trellis, std::size_t stage);

// Throws std::invalid_argument naming stage and seam if indices are out of
// range, a number is not finite, a cost is negative, a seam occurs twice, a
// seam visits a node twice, or `via`, `more_resources` and `more_limits` are of
// different lengths.
TrellisSummary CheckTrellis(const Trellis& trellis);

}  // namespace kg_planner

#endif  // KG_PLANNER_TRELLIS_TRELLIS_CHECK_H_
