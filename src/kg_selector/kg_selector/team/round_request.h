// Requests of a team to its planners between two rounds, and its report at the
// end of the run. Planners may be in any process: these values are all they
// receive, and candidates (agent_candidates.h) all they return.

#ifndef KG_SELECTOR_TEAM_ROUND_REQUEST_H_
#define KG_SELECTOR_TEAM_ROUND_REQUEST_H_

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "kg_compiler/traversal/traversal.h"
#include "kg_selector/paths/conflict.h"
#include "kg_selector/team/committed_plan.h"
#include "kg_selector/team/coordinator.h"

namespace kg_selector {

// A constraint on one agent in the round: the track of a committed agent, or
// full events (then by_agent and track may be empty).
struct CoolingConstraint {
  std::string agent;          // ex:id of the agent to be cooled.
  std::string by_agent;       // ex:id of the committed agent.
  double separation_m = 0.0;  // Distance to the track at all times [m].
  double factor = 0.0;     // Factor on rewards there, in [0, 1]; 0 = forbidden.
  double expires_s = 0.0;  // Unix seconds.
  std::vector<kg_compiler::TimedPoint> track;
  std::vector<std::string> full_events;  // IRIs.
};

// The price of visiting a waypoint, or of earning an event's reward.
struct VisitPrice {
  std::string agent;  // ex:id; empty: all agents.
  int window = 0;
  int waypoint = 0;    // Id in the agent's NavGraph.
  std::string event;   // IRI; if not empty the price is that of the event.
  double price = 0.0;  // Reward units.
};

// The agents in `asked` replan around their constraints and under these prices
// only (earlier rounds are forgotten).
struct RoundRequest {
  double time_s = 0.0;  // Unix seconds.
  std::uint64_t world_version = 0;
  std::uint64_t cycle = 0;
  std::uint64_t run = 0;
  std::uint32_t round = 0;         // Requested round, > 0.
  std::vector<std::string> asked;  // ex:id.
  std::vector<CoolingConstraint> cooling;
  std::vector<VisitPrice> prices;
};

// End of a run, with the rejections of all its rounds.
struct RunEnd {
  double time_s = 0.0;
  std::uint64_t world_version = 0;
  std::uint64_t cycle = 0;
  std::uint64_t run = 0;
  std::vector<RecordedRejection> rejections;
};

// Is the request of a run that this end, or the end of a later run, has closed?
// They may arrive in either order. A restarted selector may use a
// run number again; what it asks is stamped later than the end.
bool HasEnded(const RoundRequest& request, const RunEnd& end);

// Adds who is asked, and what for, to a request whose time is set.
void AddAsk(const std::string& agent, const PlanRequest& ask,
            const TeamRules& rules, RoundRequest* request);

struct AskedOf {
  PlanRequest ask;
  double separation_m = 0.0;  // Distance to the committed agents [m].
};
// Extracts the request for one agent; nullopt if it is not asked. Prices
// without an agent apply to all. Throws kg_base::InputError if a price is not a
// finite number >= 0.
std::optional<AskedOf> AskOf(const RoundRequest& request,
                             const std::string& agent);

}  // namespace kg_selector

#endif  // KG_SELECTOR_TEAM_ROUND_REQUEST_H_
