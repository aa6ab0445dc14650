// Turns "plan around those who are committed" into masks on a trellis: the
// bridge between an agent's NavGraphs and the planner, which knows neither
// agents nor places.

#ifndef KG_SELECTOR_MASKING_H_
#define KG_SELECTOR_MASKING_H_

#include <string>
#include <vector>

#include "kg_compiler/nav_graph.h"
#include "kg_compiler/seam_rules.h"
#include "kg_planner/k_best.h"
#include "kg_planner/trellis.h"
#include "kg_selector/conflict.h"
#include "kg_selector/pathlet.h"

namespace kg_selector {

// Stage = window, node = waypoint, token = event, resource = energy [J].
kg_planner::Trellis ToTrellis(const kg_compiler::SeamRules& rules,
                              const std::vector<kg_compiler::NavGraph>& graphs);

// Every seam whose flight comes too close to a committed track, and every node
// that visits an event without capacity left, so that whatever is planned under
// the masks has no hard conflict (FindConflict) with `committed`.
kg_planner::Masks MaskCommitted(
    const TeamRules& rules, const std::vector<kg_compiler::NavGraph>& graphs,
    const std::vector<Pathlet>& committed);

// A planner's path with the places and times behind its numbers.
Pathlet ToPathlet(const kg_compiler::SeamRules& rules,
                  const std::vector<kg_compiler::NavGraph>& graphs,
                  const kg_planner::Path& path, int rank);

}  // namespace kg_selector

#endif  // KG_SELECTOR_MASKING_H_
