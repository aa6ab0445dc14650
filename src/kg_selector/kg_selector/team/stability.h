// How much of a plan a new one keeps (A34).

#ifndef KG_SELECTOR_TEAM_STABILITY_H_
#define KG_SELECTOR_TEAM_STABILITY_H_

#include <limits>
#include <vector>

#include "kg_selector/paths/pathlet.h"

namespace kg_selector {

// Over the agents' windows that both plans have; NaN if there are none.
struct PlanStability {
  // Share that ends at the same place: within kSamePlace_m (conflict.h).
  double share = std::numeric_limits<double>::quiet_NaN();
  // Mean distance between where they end [m].
  double displacement_m = std::numeric_limits<double>::quiet_NaN();
};
PlanStability ComputeStability(const std::vector<Pathlet>& before,
                               const std::vector<Pathlet>& now);

}  // namespace kg_selector

#endif  // KG_SELECTOR_TEAM_STABILITY_H_
