// Turns "plan around those who are committed" into masks on a trellis: the
// bridge between an agent's NavGraphs and the planner, which knows neither
// agents nor places.

#ifndef KG_SELECTOR_PATHS_MASKING_H_
#define KG_SELECTOR_PATHS_MASKING_H_

#include <set>
#include <string>
#include <vector>

#include "kg_compiler/control_plane/nav_graphs.h"
#include "kg_compiler/control_plane/seam_rules.h"
#include "kg_planner/k_best/k_best.h"
#include "kg_planner/trellis/trellis.h"
#include "kg_selector/paths/conflict.h"
#include "kg_selector/paths/pathlet.h"

namespace kg_selector {

// The rules without the events in `full`: visits there earn nothing more than
// their waypoint. Capacity is kept this way; no node is masked for it.
kg_compiler::SeamRules CloseEvents(kg_compiler::SeamRules rules,
                                   const std::set<std::string>& full);

// Stage = window, node = waypoint (reward: its score), token = event that
// `rules` know in that window, seam = edge of the graph, in their order, walks
// with their stops (`via`), resource = energy [J].
kg_planner::Trellis ToTrellis(const kg_compiler::SeamRules& rules,
                              const kg_compiler::NavGraphs& graphs);

// Exactly the seams whose flight, holding station included, comes too close to
// a committed track. Of `committed` only tracks are read. What is planned under
// these masks with rules that FullEvents() are closed in has no hard conflict
// (FindConflict) with `committed`.
kg_planner::PathMasks MaskCommitted(const TeamRules& rules,
                                    const kg_compiler::NavGraphs& graphs,
                                    const std::vector<Pathlet>& committed);

// A planner's path with the places and times behind its numbers. A visit is one
// window: its reward is that of all stops, and an event is listed where its
// reward is earned: the largest, the first of equals.
Pathlet ToPathlet(const kg_compiler::SeamRules& rules,
                  const kg_compiler::NavGraphs& graphs,
                  const kg_planner::Path& path, int rank);

}  // namespace kg_selector

#endif  // KG_SELECTOR_PATHS_MASKING_H_
