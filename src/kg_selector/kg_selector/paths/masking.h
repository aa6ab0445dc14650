// Turns "plan around the committed paths" into masks on a trellis: the bridge
// between an agent's NavGraphs and the planner, which knows neither agents nor
// places.

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

// The rules without the events in `full`: visits there earn only the waypoint's
// reward. This enforces capacity without masking nodes.
kg_compiler::SeamRules CloseEvents(kg_compiler::SeamRules rules,
                                   const std::set<std::string>& full);

// Stage = window, node = waypoint (reward: its score), token = event that
// `rules` know in that window, seam = edge of the graph, in their order, walks
// with their stops (`via`), resource = energy [J].
kg_planner::Trellis ToTrellis(const kg_compiler::SeamRules& rules,
                              const kg_compiler::NavGraphs& graphs);

// Masks exactly the seams whose flight, station holding included, comes too
// close to a committed track. Only the tracks of `committed` are read. A path
// planned under these masks, with rules in which FullEvents() are closed, has
// no hard conflict (FindConflict) with `committed`.
kg_planner::PathMasks MaskCommitted(const TeamRules& rules,
                                    const kg_compiler::NavGraphs& graphs,
                                    const std::vector<Pathlet>& committed);

// Adds places and times to a planner's path. A visit is one window: its reward
// is that of all its stops; an event is listed in the window where its reward
// is largest (the first of equals).
Pathlet ToPathlet(const kg_compiler::SeamRules& rules,
                  const kg_compiler::NavGraphs& graphs,
                  const kg_planner::Path& path, int rank);

}  // namespace kg_selector

#endif  // KG_SELECTOR_PATHS_MASKING_H_
