// A price for every limited resource, so that the bound of the paths within the
// limits is least: the dual of the limits,
//
//   min over prices >= 0 of  max over paths of (score - prices . use)
//                            + prices . limits .
//
// One limit by secants [1]; several by subgradient steps towards a level below
// the least bound so far [2]. Any prices give a valid bound; these a close one.
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

// Scores of paths under prices, for which the grid may be too fine.
ScoreGrid PricedGrid(const LimitedSearch& search, const Prices& prices);

// What to add to a path's bound under prices, if it is within the limits, lest
// it lie below its score: the limits' worth, and what rounding can do.
double BoundOffset(const LimitedSearch& search, const ScoreGrid& grid,
                   const Prices& prices);

struct ResourcePrices {
  Prices prices;                        // Empty: no limit binds.
  std::vector<std::vector<int>> tried;  // Seams of the best path of each try.
  bool none_allowed = false;            // No path is within all limits.
};

ResourcePrices FindPrices(const LimitedSearch& search);

}  // namespace kg_planner

#endif  // KG_PLANNER_K_BEST_RESOURCE_PRICES_H_
