// True value of a path: each token earned once, every resource summed.

#ifndef KG_PLANNER_K_BEST_PATH_VALUE_H_
#define KG_PLANNER_K_BEST_PATH_VALUE_H_

#include <vector>

#include "kg_planner/k_best/path.h"
#include "kg_planner/k_best/search_trellis.h"
#include "kg_planner/trellis/score_grid.h"
#include "kg_planner/trellis/trellis.h"

namespace kg_planner {

struct ValuedPath {
  double score = 0.0;       // Rounded to the grid.
  std::vector<int> places;  // Ranks of its seams in the order of ties.
  Path path;
};

// True if `a` has the larger score, or is first in the order of ties.
bool IsBetter(const ValuedPath& a, const ValuedPath& b);

// Value of the path over these seams of `search`, which was made from
// `trellis`.
ValuedPath Evaluate(const Trellis& trellis, const ScoreGrid& grid,
                    const SearchTrellis& search, const std::vector<int>& seams);

bool IsWithinLimits(const Trellis& trellis, const Path& path);

}  // namespace kg_planner

#endif  // KG_PLANNER_K_BEST_PATH_VALUE_H_
