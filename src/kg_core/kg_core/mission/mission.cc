#include "kg_core/mission/mission.h"

#include <algorithm>
#include <tuple>

namespace kg_core {
namespace {

template <typename Value>
bool IsEmptyOrHas(const std::vector<Value>& values, const Value& wanted) {
  return values.empty() ||
         std::find(values.begin(), values.end(), wanted) != values.end();
}

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
  return IsEmptyOrHas(windows, window) && IsEmptyOrHas(agents, agent_iri);
}

const Agent* Mission::FindAgent(const std::string& iri) const {
  const auto found =
      std::find_if(agents.begin(), agents.end(),
                   [&](const Agent& agent) { return agent.iri == iri; });
  return found == agents.end() ? nullptr : &*found;
}

}  // namespace kg_core
