// Similarity of a new plan to the previous one (A34).

#ifndef KG_SELECTOR_TEAM_STABILITY_H_
#define KG_SELECTOR_TEAM_STABILITY_H_

#include <limits>
#include <vector>

#include "kg_selector/paths/pathlet.h"

namespace kg_selector {

// Over the (agent, window) pairs that both plans have; NaN if there are none.
struct PlanStability {
  // Share of pairs with the same end place: within kSamePlace_m (conflict.h).
  double share = std::numeric_limits<double>::quiet_NaN();
  // Mean distance between end places [m].
  double displacement_m = std::numeric_limits<double>::quiet_NaN();
};
PlanStability ComputeStability(const std::vector<Pathlet>& before,
                               const std::vector<Pathlet>& now);

}  // namespace kg_selector

#endif  // KG_SELECTOR_TEAM_STABILITY_H_
