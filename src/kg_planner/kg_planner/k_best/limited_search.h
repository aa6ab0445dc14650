// A trellis prepared for the searches of this package: checked, without masked
// or unaffordable seams, with repeated tokens unrolled.

#ifndef KG_PLANNER_K_BEST_LIMITED_SEARCH_H_
#define KG_PLANNER_K_BEST_LIMITED_SEARCH_H_

#include <vector>

#include "kg_planner/k_best/path.h"
#include "kg_planner/k_best/plain_pass.h"
#include "kg_planner/k_best/search_trellis.h"
#include "kg_planner/trellis/score_grid.h"
#include "kg_planner/trellis/trellis.h"

namespace kg_planner {

struct LimitedSearch {
  SearchTrellis search;
  ScoreGrid grid;
  double largest_total = 0.0;  // Upper bound of any partial score.
  std::vector<double> limits;  // Limit by resource; infinity = none.
  // True: without limits, a path's bound without prices equals its score on the
  // grid.
  bool tokens_are_exact = true;

  // Viterbi levels without prices, if the checking pass computed them; else
  // empty.
  std::vector<ViterbiLevel> levels = {};

  bool IsLimited() const;
};

// Throws as CheckTrellis() does, and if a mask names an unknown stage or node.
// `trellis` must outlive the result.
LimitedSearch MakeSearch(const Trellis& trellis, const PathMasks& masks);

}  // namespace kg_planner

#endif  // KG_PLANNER_K_BEST_LIMITED_SEARCH_H_
