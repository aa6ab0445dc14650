// Rules of an agent's paths beyond their terms: which paths are offered, and
// budgets over the horizon.

#ifndef KG_SELECTOR_PATHS_PATH_RULES_H_
#define KG_SELECTOR_PATHS_PATH_RULES_H_

#include <string>

#include "kg_compiler/control_plane/nav_graphs.h"
#include "kg_compiler/control_plane/seam_rules.h"
#include "kg_planner/k_best/k_best.h"
#include "kg_planner/trellis/trellis.h"

namespace kg_selector {

// Turns a hazard budget into a second resource of the trellis (the first is
// energy): hazard and isolation of its seams [s]. No effect without a budget.
void LimitHazard(const kg_compiler::SeamRules& rules,
                 const kg_compiler::NavGraphs& graphs,
                 kg_planner::Trellis* trellis);

// The paths to offer: the K best, or K diverse ones if the policy requires it
// (diverse_paths.h). Called by every planner, in any process. `memory` (may be
// null) is that of the agent's last search for the K best.
kg_planner::KBest ChoosePaths(const kg_compiler::SeamRules& rules,
                              const kg_planner::Trellis& trellis,
                              const kg_planner::PathMasks& masks,
                              kg_planner::KBestMemory* memory = nullptr);

// Text on how much the budgets fall short, if `found` shows that this is why
// there is no path: "no path within 12.3 Wh: the cheapest takes 15.1 Wh".
// Empty otherwise.
std::string BudgetNote(const kg_compiler::SeamRules& rules,
                       const kg_planner::KBest& found);

}  // namespace kg_selector

#endif  // KG_SELECTOR_PATHS_PATH_RULES_H_
