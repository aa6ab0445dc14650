// What it costs to leave the plan in force (A34): replans stay put unless
// moving is worth more than that.
//
//   churn(x) = churn_weight min(1, d(x, committed) / spacing)
//
// in reward units, for the place x where a window ends, if the plan in force
// says where it ends; d the geodesic distance [m], spacing that of waypoints
// (the sensor's radius if that is 0). It is charged on the way there, beside
// S of the seam: a path's rewards stay what is earned.

#ifndef KG_SELECTOR_PATHS_CHURN_H_
#define KG_SELECTOR_PATHS_CHURN_H_

#include "kg_base/geo/lon_lat.h"
#include "kg_compiler/control_plane/nav_graphs.h"
#include "kg_compiler/control_plane/seam_rules.h"
#include "kg_planner/trellis/trellis.h"

namespace kg_selector {

// 0 if the window is not committed, not of `rules`, or the weight is 0.
double ChurnCost(const kg_compiler::SeamRules& rules, int window,
                 const kg_base::LonLat& place);

// Adds it to the cost of every seam of a trellis of these graphs. Nothing at
// all changes without commitments.
void AddChurn(const kg_compiler::SeamRules& rules,
              const kg_compiler::NavGraphs& graphs,
              kg_planner::Trellis* trellis);

}  // namespace kg_selector

#endif  // KG_SELECTOR_PATHS_CHURN_H_
