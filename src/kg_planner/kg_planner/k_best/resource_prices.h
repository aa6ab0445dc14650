// Prices of the limited resources that minimise the upper bound of the paths
// within the limits: the dual of the limits,
//
//   min over prices >= 0 of  max over paths of (score - prices . use)
//                            + prices . limits .
//
// One limit is solved by secants [1]; several by subgradient steps towards a
// level below the smallest bound so far [2]. Any prices give a valid bound;
// these give a tight one.
//
// [1] A. Juttner et al., "Lagrange relaxation based method for the QoS routing
//     problem", INFOCOM 2001.
// [2] U. Brannlund, "A generalized subgradient method with relaxation step",
//     Mathematical Programming 71 (1995), 207-219.

#ifndef KG_PLANNER_K_BEST_RESOURCE_PRICES_H_
#define KG_PLANNER_K_BEST_RESOURCE_PRICES_H_

#include <vector>

#include "kg_planner/k_best/limited_search.h"
#include "kg_planner/k_best/path_enumerator.h"
#include "kg_planner/trellis/score_grid.h"

namespace kg_planner {

// Grid for scores of paths under prices, which may exceed the range of the
// search's grid.
ScoreGrid PricedGrid(const LimitedSearch& search, const Prices& prices);

// Amount to add to a path's bound under prices so that it is not below its
// score, if it is within the limits: prices . limits plus a rounding margin.
double BoundOffset(const LimitedSearch& search, const ScoreGrid& grid,
                   const Prices& prices);

struct ResourcePrices {
  Prices prices;  // Empty = no limit is binding.
  // Seams of the best path for each prices tried.
  std::vector<std::vector<int>> tried;
  bool none_allowed = false;  // True if no path is within all limits.
};

ResourcePrices FindPrices(const LimitedSearch& search);

}  // namespace kg_planner

#endif  // KG_PLANNER_K_BEST_RESOURCE_PRICES_H_
