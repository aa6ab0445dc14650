// One pass over the seams that leave one node: the best suffix over any of
// them, and whether their numbers are valid. Memory-bound: the check adds no
// measurable cost.

#ifndef KG_PLANNER_K_BEST_ROW_KERNEL_H_
#define KG_PLANNER_K_BEST_ROW_KERNEL_H_

#include "kg_planner/trellis/trellis.h"

namespace kg_planner {

struct RowScan {
  double best = 0.0;          // max of onward[to] - round(cost).
  double largest_cost = 0.0;  // Valid only if `sound`.
  // True if every `from` equals the first, `to` ascends, costs and resources
  // are finite and >= 0 (a -0 counts as not sound).
  bool sound = false;
};

struct OnwardScores {
  const double* by_node = nullptr;
  int nodes = 0;
  double shift = 0.0;  // ScoreGrid::shift().
};

// Precondition: the first `to` is >= 0 and the last < nodes; those between are
// checked here. `count` > 0.
RowScan ScanRow(const Seam* seams, int count, const OnwardScores& onward);

}  // namespace kg_planner

#endif  // KG_PLANNER_K_BEST_ROW_KERNEL_H_
