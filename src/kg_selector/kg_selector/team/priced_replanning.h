// One agent's answer to a request of its team, wherever its planner runs: a
// pure function of the agent, its NavGraphs and the PlanRequest.
//
//   maximise  score - prices    over paths around those committed
//
// Prices count in what is chosen and in its order, and in AgentOffer::bound;
// the reward of a Pathlet never has them. A waypoint's price is paid by a path
// that ends its window there (stops on the way are free), an event's by a path
// that earns it. An event that costs as much as it rewards in a window is not
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
  // One a window of `rules`; none = the agent cannot be planned.
  kg_compiler::NavGraphs graphs;
  // What the last search for the K best left for the next one; may be null. The
  // paths are the same without it.
  std::shared_ptr<kg_planner::KBestMemory> memory = {};
};

// What a team calls its members, as the selector node does: the ex:id, or the
// IRI of who has none.
const std::string& NameOf(const TeamMember& member);

// What a planner says that found no path, alone or around those committed.
const char* NoPathNote(bool alone);

// `rules` for a path that pays the event prices of `request` and is too late
// for its full events: what it can still earn, unpriced.
kg_compiler::SeamRules OpenRules(const kg_compiler::SeamRules& rules,
                                 const PlanRequest& request);

// The trellis of `open` (OpenRules) less the prices of `request`. Throws
// kg_base::InputError for a price that is negative or not finite, and for a
// waypoint that is not there.
kg_planner::Trellis PricedTrellis(const kg_compiler::SeamRules& open,
                                  const kg_compiler::NavGraphs& graphs,
                                  const PlanRequest& request);

// A path found under prices, worth what it is without them.
kg_planner::Path Unpriced(const kg_planner::Trellis& unpriced,
                          kg_planner::Path path);

// None of the paths has a hard conflict with request.around. Of the team's
// rules those of separation and the windows' ends are read.
AgentOffer PlanPriced(const TeamRules& team, const TeamMember& member,
                      const PlanRequest& request);

}  // namespace kg_selector

#endif  // KG_SELECTOR_TEAM_PRICED_REPLANNING_H_
