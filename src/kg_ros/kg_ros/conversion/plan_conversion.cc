#include "kg_ros/conversion/plan_conversion.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "kg_core/base/input_error.h"
#include "kg_ros/conversion/message_units.h"

namespace kg_ros {
namespace {

using kg_compiler::NavGraph;
using kg_compiler::NavGraphs;
using kg_compiler::TimedPoint;
using kg_compiler::TraverseEdge;

kg_msgs::Waypoint ToMessage(const kg_compiler::Waypoint& waypoint) {
  kg_msgs::Waypoint message;
  message.id = waypoint.id;
  SetPosition(waypoint.position, &message);
  message.score = waypoint.score;
  message.value = waypoint.value;
  message.event_reward = waypoint.event_reward;
  message.events = waypoint.events;
  message.footprint.assign(waypoint.footprint.begin(),
                           waypoint.footprint.end());
  return message;
}

kg_compiler::Waypoint FromMessage(const kg_msgs::Waypoint& message) {
  kg_compiler::Waypoint waypoint;
  waypoint.id = static_cast<int>(message.id);
  waypoint.position = GetPosition(message);
  waypoint.score = message.score;
  waypoint.value = message.value;
  waypoint.event_reward = message.event_reward;
  waypoint.events = message.events;
  waypoint.footprint.assign(message.footprint.begin(), message.footprint.end());
  return waypoint;
}

TraverseEdge FromMessage(const kg_msgs::TraverseEdge& message) {
  TraverseEdge edge;
  edge.from = static_cast<int>(message.from);
  edge.to = static_cast<int>(message.to);
  edge.via.assign(message.via.begin(), message.via.end());
  edge.flight.track = kg_ros::FromMessage(message.track);
  edge.flight.travel_s = message.cost.travel_s;
  edge.flight.energy_j = message.cost.energy_j;
  edge.flight.hazard_s = message.cost.hazard_s;
  edge.flight.through_water_m = message.cost.through_water_m;
  edge.flight.speed_mps = message.cost.speed_mps;
  edge.seam_cost = message.cost.seam_cost;
  edge.isolation_s = message.cost.isolation_s;
  edge.exposures = message.cost.exposures;
  return edge;
}

kg_msgs::TraverseEdge ToMessage(const TraverseEdge& edge) {
  kg_msgs::TraverseEdge message;
  message.from = edge.from;
  message.to = edge.to;
  message.via.assign(edge.via.begin(), edge.via.end());
  message.cost = CostMessage(edge);
  message.track = kg_ros::ToMessage(edge.flight.track);
  return message;
}

// Do an edge's ends and stops lie among its graph's waypoints?
bool IsJoined(const kg_msgs::TraverseEdge& edge, std::size_t waypoints) {
  const auto is_there = [&](std::uint32_t id) { return id < waypoints; };
  return is_there(edge.to) && (!edge.within_window || is_there(edge.from)) &&
         std::all_of(edge.via.begin(), edge.via.end(), is_there);
}

kg_msgs::Visit ToMessage(const kg_selector::Visit& visit) {
  kg_msgs::Visit message;
  message.window = visit.window;
  message.waypoint = visit.waypoint;
  SetPosition(visit.position, &message);
  message.reward = visit.reward;
  message.events = visit.events;
  for (const kg_selector::Stop& stop : visit.via) {
    message.via.emplace_back();
    message.via.back().waypoint = stop.waypoint;
    SetPosition(stop.position, &message.via.back());
  }
  return message;
}

void RequireFinite(double value, const std::string& agent, const char* field) {
  if (std::isfinite(value)) return;
  throw kg_core::InputError("Pathlet of " + agent + ": " + field +
                            " must be finite");
}

kg_selector::Visit FromMessage(const kg_msgs::Visit& message,
                               const std::string& agent) {
  kg_selector::Visit visit;
  visit.window = message.window;
  visit.waypoint = static_cast<int>(message.waypoint);
  visit.position = GetPosition(message);
  visit.reward = message.reward;
  visit.events = message.events;
  RequireFinite(message.reward, agent, "the reward of a visit");
  RequireFinite(message.lon_rad + message.lat_rad, agent,
                "the place of a visit");
  for (const kg_msgs::Stop& stop : message.via) {
    RequireFinite(stop.lon_rad + stop.lat_rad, agent, "the place of a stop");
    visit.via.push_back({static_cast<int>(stop.waypoint), GetPosition(stop)});
  }
  return visit;
}

}  // namespace

kg_msgs::EdgeCost CostMessage(const TraverseEdge& edge) {
  kg_msgs::EdgeCost cost;
  cost.travel_s = edge.flight.travel_s;
  cost.energy_j = edge.flight.energy_j;
  cost.hazard_s = edge.flight.hazard_s;
  cost.through_water_m = edge.flight.through_water_m;
  cost.speed_mps = edge.flight.speed_mps;
  cost.isolation_s = edge.isolation_s;
  cost.exposures = edge.exposures;
  cost.seam_cost = edge.seam_cost;
  return cost;
}

std::vector<kg_msgs::TimedPoint> ToMessage(
    const std::vector<TimedPoint>& track) {
  std::vector<kg_msgs::TimedPoint> message;
  message.reserve(track.size());
  for (const TimedPoint& point : track) {
    message.emplace_back();
    SetPosition(point.position, &message.back());
    message.back().stamp = ToRosTime(point.time_s);
  }
  return message;
}

std::vector<TimedPoint> FromMessage(
    const std::vector<kg_msgs::TimedPoint>& message) {
  std::vector<TimedPoint> track;
  track.reserve(message.size());
  for (const kg_msgs::TimedPoint& point : message) {
    const double time_s = FromRosTime(point.stamp);
    if (!std::isfinite(point.lon_rad) || !std::isfinite(point.lat_rad)) {
      throw kg_core::InputError("TimedPoint: position must be finite");
    }
    if (!track.empty() && !(time_s >= track.back().time_s)) {
      throw kg_core::InputError("TimedPoint.stamp must not go back");
    }
    track.push_back({GetPosition(point), time_s});
  }
  return track;
}

kg_msgs::NavGraph ToMessage(const NavGraph& graph,
                            const kg_compiler::SeamRules& rules) {
  kg_msgs::NavGraph message;
  message.world_version = rules.world_version;
  message.agent = rules.agent_id;
  message.agent_iri = graph.agent_iri;
  message.window = graph.window;
  message.movement_mode = kg_compiler::Name(graph.movement_mode);
  message.hash = graph.hash;
  for (const kg_compiler::Waypoint& waypoint : graph.waypoints) {
    message.waypoints.push_back(ToMessage(waypoint));
  }
  for (const TraverseEdge& edge : graph.edges) {
    message.edges.push_back(ToMessage(edge));
  }
  for (const TraverseEdge& edge : graph.inner_edges) {
    message.edges.push_back(ToMessage(edge));
    message.edges.back().within_window = true;
  }
  return message;
}

NavGraph FromMessage(const kg_msgs::NavGraph& message) {
  NavGraph graph;
  graph.agent_iri = message.agent_iri;
  graph.window = message.window;
  graph.hash = message.hash;
  graph.movement_mode = kg_compiler::MovementModeOf(message.movement_mode);
  for (const kg_msgs::Waypoint& waypoint : message.waypoints) {
    if (waypoint.id != graph.waypoints.size() ||
        !std::isfinite(waypoint.score)) {
      throw kg_core::InputError("NavGraph of " + message.agent + ", window " +
                                std::to_string(message.window) +
                                ": waypoints must be numbered from 0 and "
                                "scores finite");
    }
    graph.waypoints.push_back(FromMessage(waypoint));
  }
  for (const kg_msgs::TraverseEdge& edge : message.edges) {
    if (!IsJoined(edge, message.waypoints.size()) ||
        !std::isfinite(edge.cost.seam_cost)) {
      throw kg_core::InputError("NavGraph of " + message.agent + ", window " +
                                std::to_string(message.window) +
                                ": edges must lead to its waypoints, by way "
                                "of its waypoints, and costs be finite");
    }
    auto& edges = edge.within_window ? graph.inner_edges : graph.edges;
    edges.push_back(FromMessage(edge));
  }
  return graph;
}

kg_msgs::Pathlet ToMessage(const kg_selector::Pathlet& pathlet,
                           const NavGraphs& graphs) {
  kg_msgs::Pathlet message;
  message.rank = pathlet.rank;
  message.reward = pathlet.reward;
  message.seam_cost = pathlet.seam_cost;
  message.energy_j = pathlet.energy_j;
  int from = 0;
  for (std::size_t i = 0; i < pathlet.visits.size(); ++i) {
    const kg_selector::Visit& visit = pathlet.visits[i];
    message.visits.push_back(ToMessage(visit));
    if (i < graphs.size()) {
      const TraverseEdge* edge = kg_compiler::FindEdge(
          graphs[i], from, visit.waypoint, kg_selector::ViaOf(visit));
      if (edge != nullptr) message.visits.back().cost = CostMessage(*edge);
    }
    from = visit.waypoint;
  }
  message.track = ToMessage(pathlet.track);
  return message;
}

kg_selector::Pathlet FromMessage(const kg_msgs::Pathlet& message,
                                 const std::string& agent) {
  RequireFinite(message.reward, agent, "reward");
  RequireFinite(message.seam_cost, agent, "seam_cost");
  RequireFinite(message.energy_j, agent, "energy_j");
  kg_selector::Pathlet pathlet;
  pathlet.agent = agent;
  pathlet.rank = static_cast<int>(message.rank);
  pathlet.reward = message.reward;
  pathlet.seam_cost = message.seam_cost;
  pathlet.energy_j = message.energy_j;
  for (const kg_msgs::Visit& visit : message.visits) {
    pathlet.visits.push_back(FromMessage(visit, agent));
  }
  pathlet.track = FromMessage(message.track);
  return pathlet;
}

kg_msgs::Rejection ToMessage(const kg_selector::Rejection& rejection,
                             const std::string& agent_iri) {
  kg_msgs::Rejection message;
  message.agent = rejection.pathlet.agent;
  message.agent_iri = agent_iri;
  message.rank = rejection.pathlet.rank;
  message.round = rejection.round;
  message.score = rejection.pathlet.score();
  message.kind = kg_selector::Name(rejection.conflict.kind);
  message.to_agent = rejection.conflict.with_agent;
  message.window = rejection.conflict.window;
  message.event = rejection.conflict.event;
  message.margin = rejection.conflict.margin;
  message.reason = rejection.reason;
  return message;
}

kg_msgs::Assignments ToMessage(const kg_selector::PlannedMission& planned) {
  kg_msgs::Assignments message;
  message.rounds = planned.plan.rounds - 1;  // Of planning again.
  message.mode = planned.rules.mode;
  message.bound = FiniteOrUnknown(planned.plan.bound);
  message.stability = message.displacement_m =
      std::numeric_limits<double>::quiet_NaN();
  for (const kg_selector::Pathlet& pathlet : planned.plan.committed) {
    const kg_selector::TeamMember* member = planned.FindMember(pathlet.agent);
    kg_msgs::Assignment assignment;
    assignment.agent = pathlet.agent;
    assignment.agent_iri = member->rules.agent_iri;
    assignment.pathlet = ToMessage(pathlet, member->graphs);
    message.reward += pathlet.reward;
    message.seam_cost += pathlet.seam_cost;
    message.assignments.push_back(assignment);
  }
  for (const auto& [agent, why] : planned.plan.unassigned) {
    message.unassigned.push_back(agent + ": " + why);
  }
  return message;
}

kg_core::LonLat PositionAt(const std::vector<TimedPoint>& track,
                           const double time_s) {
  const auto after = std::lower_bound(
      track.begin(), track.end(), time_s,
      [](const TimedPoint& point, double t) { return point.time_s < t; });
  if (after == track.begin()) return track.front().position;
  if (after == track.end()) return track.back().position;
  const TimedPoint& a = *(after - 1);
  const TimedPoint& b = *after;
  const double share = (time_s - a.time_s) / (b.time_s - a.time_s);
  return {
      a.position.lon_deg + share * (b.position.lon_deg - a.position.lon_deg),
      a.position.lat_deg + share * (b.position.lat_deg - a.position.lat_deg)};
}

}  // namespace kg_ros
