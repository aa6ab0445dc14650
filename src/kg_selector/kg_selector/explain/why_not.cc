#include "kg_selector/explain/why_not.h"

#include <algorithm>
#include <string>
#include <vector>

#include "kg_base/common/input_error.h"
#include "kg_compiler/explain/explain_tensor.h"
#include "kg_selector/explain/explain_via.h"
#include "kg_selector/explain/why_not_place.h"

namespace kg_selector {

using kg_base::InputError;
using kg_base::LonLat;
using kg_compiler::Explanation;
using kg_compiler::Waypoint;
using kg_mission::Agent;

Explanation WhyNotWaypoint(const PlannedWorld& world, const Agent& agent,
                           const WaypointName& waypoint) {
  const TeamMember& member = FindMember(world, agent);
  const std::size_t stage = FindStage(member, waypoint.window);
  const std::size_t count = member.graphs[stage].waypoints.size();
  const std::string name = "waypoint " + std::to_string(waypoint.id) + " of " +
                           "window " + std::to_string(waypoint.window);
  if (waypoint.id < 0 || waypoint.id >= static_cast<int>(count)) {
    throw InputError(agent.id + " has no " + name + ": there are " +
                     std::to_string(count) + ", numbered from 0");
  }
  const Visit& visit = NeedPath(world, agent).visits.at(stage);
  const std::vector<int> stops = StopsOf(visit);
  if (std::count(stops.begin(), stops.end(), waypoint.id) > 0) {
    return ExplainTaken(world, agent, visit, name);
  }
  return ExplainPathVia(world, agent, {stage, {waypoint.id}, name});
}

Explanation WhyNotPlace(const PlannedWorld& world, const Agent& agent,
                        LonLat place, int window) {
  const TeamMember& member = FindMember(world, agent);
  const std::size_t stage = FindStage(member, window);
  NeedPath(world, agent);
  const auto& tensor =
      kg_compiler::FindTensor(*world.compilation, agent, window);
  const auto cell = tensor.grid.CellAt(place);
  for (const Waypoint& waypoint : member.graphs[stage].waypoints) {
    const auto other = tensor.grid.CellAt(waypoint.position);
    if (cell && other && *cell == *other) {
      return WhyNotWaypoint(world, agent, {window, waypoint.id});
    }
  }
  return NoWaypointThere(world, agent, place, stage);
}

}  // namespace kg_selector
