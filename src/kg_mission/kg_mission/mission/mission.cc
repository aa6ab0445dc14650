#include "kg_mission/mission/mission.h"

#include <algorithm>
#include <tuple>

#include "kg_mission/mission/scope.h"

namespace kg_mission {
namespace {

auto Tie(const CoordinationFacts& f) {
  return std::tie(f.mode, f.gap_goal, f.auction_epsilon, f.select_limit_s,
                  f.fairness, f.fairness_weight, f.separation_m,
                  f.separation_is_hard, f.separation_weight,
                  f.candidates_per_agent, f.waypoints_per_window,
                  f.waypoint_spacing_m, f.max_rounds, f.movement_mode);
}

}  // namespace

bool operator==(const CoordinationFacts& a, const CoordinationFacts& b) {
  return Tie(a) == Tie(b);
}

bool Constraint::AppliesTo(const std::string& agent_iri, int window) const {
  return InScope(windows, window) && InScope(agents, agent_iri);
}

const Agent* Mission::FindAgent(const std::string& iri) const {
  const auto found =
      std::find_if(agents.begin(), agents.end(),
                   [&](const Agent& agent) { return agent.iri == iri; });
  return found == agents.end() ? nullptr : &*found;
}

}  // namespace kg_mission
