// Cost of deviating from the plan in force (A34): a replan changes only where
// the gain exceeds this cost.
//
//   churn(x) = churn_weight min(1, d(x, committed) / spacing)
//
// in reward units, for the place x where a window ends, if the plan in force
// defines an end place for that window; d is the geodesic distance [m], spacing
// that of the waypoints (the sensor radius if that is 0). It is charged on the
// seam into the place, in addition to S: the reward of a path does not change.

#ifndef KG_SELECTOR_PATHS_CHURN_H_
#define KG_SELECTOR_PATHS_CHURN_H_

#include "kg_base/geo/lon_lat.h"
#include "kg_compiler/control_plane/nav_graphs.h"
#include "kg_compiler/control_plane/seam_rules.h"
#include "kg_planner/trellis/trellis.h"

namespace kg_selector {

// 0 if the window is not committed or not in `rules`, or if the weight is 0.
double ChurnCost(const kg_compiler::SeamRules& rules, int window,
                 const kg_base::LonLat& place);

// Adds the churn cost to every seam of a trellis of these graphs. No effect
// without commitments.
void AddChurn(const kg_compiler::SeamRules& rules,
              const kg_compiler::NavGraphs& graphs,
              kg_planner::Trellis* trellis);

}  // namespace kg_selector

#endif  // KG_SELECTOR_PATHS_CHURN_H_
