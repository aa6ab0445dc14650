// One agent's answer to a request of its team, in any process: a pure function
// of the agent, its NavGraphs and the PlanRequest.
//
//   maximise  score - prices    over paths around those committed
//
// Prices affect the choice, its order and AgentOffer::bound; the reward of a
// Pathlet excludes them. A waypoint's price is paid by a path that ends its
// window there (stops on the way are free), an event's price by a path that
// earns it. An event whose price is at least its reward in a window is not
// earned there: it is not in Visit::events.

#ifndef KG_SELECTOR_TEAM_PRICED_REPLANNING_H_
#define KG_SELECTOR_TEAM_PRICED_REPLANNING_H_

#include <memory>
#include <string>

#include "kg_compiler/control_plane/nav_graphs.h"
#include "kg_compiler/control_plane/seam_rules.h"
#include "kg_planner/k_best/k_best.h"
#include "kg_planner/k_best/k_best_memory.h"
#include "kg_planner/trellis/trellis.h"
#include "kg_selector/team/team_plan.h"

namespace kg_selector {

struct TeamMember {
  kg_compiler::SeamRules rules;
  // One per window of `rules`; empty = the agent cannot be planned.
  kg_compiler::NavGraphs graphs;
  // State of the last search for the K best, to speed up the next one; may be
  // null. The paths are the same without it.
  std::shared_ptr<kg_planner::KBestMemory> memory = {};
};

// Name of a member in its team, as in the selector node: the ex:id, or the IRI
// if it has none.
const std::string& NameOf(const TeamMember& member);

// Note of a planner that found no path, alone or around committed paths.
const char* NoPathNote(bool alone);

// `rules` for a path that pays the event prices of `request`, with the full
// events closed: what it can still earn, before prices.
kg_compiler::SeamRules OpenRules(const kg_compiler::SeamRules& rules,
                                 const PlanRequest& request);

// The trellis of `open` (OpenRules) minus the prices of `request`. Throws
// kg_base::InputError for a negative or nonfinite price and for an unknown
// waypoint.
kg_planner::Trellis PricedTrellis(const kg_compiler::SeamRules& open,
                                  const kg_compiler::NavGraphs& graphs,
                                  const PlanRequest& request);

// A path found under prices, with its value recomputed without them.
kg_planner::Path Unpriced(const kg_planner::Trellis& unpriced,
                          kg_planner::Path path);

// The K best paths without a hard conflict with request.around. Of `team`,
// separation and window ends are read.
AgentOffer PlanPriced(const TeamRules& team, const TeamMember& member,
                      const PlanRequest& request);

}  // namespace kg_selector

#endif  // KG_SELECTOR_TEAM_PRICED_REPLANNING_H_
