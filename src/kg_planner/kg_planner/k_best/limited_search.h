// A trellis made ready for the searches of this package: checked, without what
// masks forbid or no limit allows, its repeated tokens unrolled.

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
  double largest_total = 0.0;  // No part of a path's score is larger.
  std::vector<double> limits;  // By resource; infinity = none.
  // Without limits, a path's bound without prices is its score on the grid.
  bool tokens_are_exact = true;

  // Without prices, if the pass that checked the trellis made it; else empty.
  std::vector<ViterbiLevel> levels = {};

  bool IsLimited() const;
};

// Throws as CheckTrellis() does, and if a mask names what is not there.
// `trellis` must outlive the result.
LimitedSearch MakeSearch(const Trellis& trellis, const PathMasks& masks);

}  // namespace kg_planner

#endif  // KG_PLANNER_K_BEST_LIMITED_SEARCH_H_
