// What an agent's rules say of its paths beside their terms: which ones are
// offered, and what they may not exceed over the horizon.

#ifndef KG_SELECTOR_PATHS_PATH_RULES_H_
#define KG_SELECTOR_PATHS_PATH_RULES_H_

#include <string>

#include "kg_compiler/control_plane/nav_graphs.h"
#include "kg_compiler/control_plane/seam_rules.h"
#include "kg_planner/k_best/k_best.h"
#include "kg_planner/trellis/trellis.h"

namespace kg_selector {

// A budget of hazard becomes a second resource of the trellis (the first is
// energy): hazard and isolation of its seams [s]. Nothing without one.
void LimitHazard(const kg_compiler::SeamRules& rules,
                 const kg_compiler::NavGraphs& graphs,
                 kg_planner::Trellis* trellis);

// The paths that are offered: the K best, or if the policy says so K that
// differ (diverse_paths.h). Every planner calls this, in which process it may
// be. `memory` (may be null) is of the agent's last search for the K best.
kg_planner::KBest ChoosePaths(const kg_compiler::SeamRules& rules,
                              const kg_planner::Trellis& trellis,
                              const kg_planner::PathMasks& masks,
                              kg_planner::KBestMemory* memory = nullptr);

// By how much the budgets are too small, if `found` says that this is why it
// has no path: "no path within 12.3 Wh: the thriftiest takes 15.1 Wh". Else
// empty.
std::string BudgetNote(const kg_compiler::SeamRules& rules,
                       const kg_planner::KBest& found);

}  // namespace kg_selector

#endif  // KG_SELECTOR_PATHS_PATH_RULES_H_
