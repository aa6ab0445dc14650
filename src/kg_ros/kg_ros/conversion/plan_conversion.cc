#include "kg_ros/conversion/plan_conversion.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>

#include "kg_base/common/input_error.h"
#include "kg_ros/conversion/message_units.h"

namespace kg_ros {
namespace {

using kg_compiler::EdgeCost;
using kg_compiler::NavGraph;
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
  edge.turn_rad = message.cost.turn_rad;
  return edge;
}

kg_msgs::TraverseEdge ToMessage(const TraverseEdge& edge) {
  kg_msgs::TraverseEdge message;
  message.from = edge.from;
  message.to = edge.to;
  message.via.assign(edge.via.begin(), edge.via.end());
  message.cost = kg_ros::ToMessage(kg_compiler::CostOfEdge(edge));
  message.track = kg_ros::ToMessage(edge.flight.track);
  return message;
}

// Whether an edge's ends and stops are waypoints of its graph.
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
  message.cost = kg_ros::ToMessage(visit.cost);
  return message;
}

void RequireFinite(double value, const std::string& agent, const char* field) {
  if (std::isfinite(value)) return;
  throw kg_base::InputError("Pathlet of " + agent + ": " + field +
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
  visit.cost = kg_ros::FromMessage(message.cost);
  return visit;
}

kg_msgs::Cooling ToMessage(const kg_selector::CoolingConstraint& cooling) {
  kg_msgs::Cooling message;
  message.agent = cooling.agent;
  message.by_agent = cooling.by_agent;
  message.separation_m = cooling.separation_m;
  message.factor = cooling.factor;
  message.expires = ToRosTime(cooling.expires_s);
  message.track = kg_ros::ToMessage(cooling.track);
  message.full_events = cooling.full_events;
  return message;
}

kg_selector::CoolingConstraint FromMessage(const kg_msgs::Cooling& message) {
  kg_selector::CoolingConstraint cooling;
  cooling.agent = message.agent;
  cooling.by_agent = message.by_agent;
  cooling.separation_m = message.separation_m;
  cooling.factor = message.factor;
  cooling.expires_s = FromRosTime(message.expires);
  cooling.track = kg_ros::FromMessage(message.track);
  cooling.full_events = message.full_events;
  return cooling;
}

kg_msgs::Price ToMessage(const kg_selector::VisitPrice& price) {
  kg_msgs::Price message;
  message.agent = price.agent;
  message.window = price.window;
  message.waypoint = price.waypoint;
  message.event = price.event;
  message.price = price.price;
  return message;
}

kg_selector::VisitPrice FromMessage(const kg_msgs::Price& message) {
  return {message.agent, message.window, static_cast<int>(message.waypoint),
          message.event, message.price};
}

kg_msgs::Rejection ToMessage(const kg_selector::RecordedRejection& rejected) {
  const kg_selector::RejectedPath& rejection = rejected.rejection;
  kg_msgs::Rejection message;
  message.agent = rejection.pathlet.agent;
  message.agent_iri = rejected.agent_iri;
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

// Messages carry only agent, rank and score of the pathlet.
kg_selector::RecordedRejection FromMessage(const kg_msgs::Rejection& message) {
  kg_selector::RecordedRejection rejected;
  rejected.agent_iri = message.agent_iri;
  kg_selector::RejectedPath& rejection = rejected.rejection;
  rejection.pathlet.agent = message.agent;
  rejection.pathlet.rank = static_cast<int>(message.rank);
  rejection.pathlet.reward = message.score;
  rejection.round = static_cast<int>(message.round);
  rejection.reason = message.reason;
  rejection.conflict.kind =
      kg_selector::ParseConflictKind(message.kind)
          .value_or(kg_selector::ConflictKind::kMalformed);
  rejection.conflict.with_agent = message.to_agent;
  rejection.conflict.window = message.window;
  rejection.conflict.event = message.event;
  rejection.conflict.margin = message.margin;
  return rejected;
}

// Sets time, version, cycle and run of a selector's message.
template <typename Message, typename Value>
void SetHeader(const Value& value, Message* message) {
  message->header.stamp = ToRosTime(value.time_s);
  message->world_version = value.world_version;
  message->cycle = value.cycle;
  message->plan_run = value.run;
}
template <typename Value, typename Message>
Value FromHeader(const Message& message) {
  Value value;
  value.time_s = FromRosTime(message.header.stamp);
  value.world_version = message.world_version;
  value.cycle = message.cycle;
  value.run = message.plan_run;
  return value;
}

// Parses "id: reason".
void AddUnassigned(const std::string& line, kg_selector::CommittedPlan* plan) {
  const std::size_t colon = line.find(": ");
  const bool has_reason = colon != std::string::npos;
  plan->unassigned[line.substr(0, colon)] =
      has_reason ? line.substr(colon + 2) : "";
}

}  // namespace

kg_msgs::EdgeCost ToMessage(const EdgeCost& cost) {
  kg_msgs::EdgeCost message;
  message.travel_s = cost.travel_s;
  message.energy_j = cost.energy_j;
  message.hazard_s = cost.hazard_s;
  message.through_water_m = cost.through_water_m;
  message.speed_mps = cost.speed_mps;
  message.isolation_s = cost.isolation_s;
  message.exposures = cost.exposures;
  message.turn_rad = cost.turn_rad;
  message.seam_cost = cost.seam_cost;
  return message;
}

EdgeCost FromMessage(const kg_msgs::EdgeCost& message) {
  EdgeCost cost;
  cost.travel_s = message.travel_s;
  cost.energy_j = message.energy_j;
  cost.hazard_s = message.hazard_s;
  cost.through_water_m = message.through_water_m;
  cost.speed_mps = message.speed_mps;
  cost.isolation_s = message.isolation_s;
  cost.exposures = message.exposures;
  cost.turn_rad = message.turn_rad;
  cost.seam_cost = message.seam_cost;
  return cost;
}

kg_msgs::StageTime ToMessage(const kg_selector::StageTime& stage) {
  kg_msgs::StageTime message;
  message.stage = stage.stage;
  message.seconds = stage.seconds;
  message.count = static_cast<unsigned>(stage.count);
  return message;
}

std::vector<kg_msgs::StageTime> ToMessage(
    const std::vector<kg_selector::StageTime>& stages) {
  std::vector<kg_msgs::StageTime> message;
  for (const auto& stage : stages) message.push_back(ToMessage(stage));
  return message;
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
      throw kg_base::InputError("TimedPoint: position must be finite");
    }
    if (!track.empty() && !(time_s >= track.back().time_s)) {
      throw kg_base::InputError("TimedPoint.stamp must not go back");
    }
    track.push_back({GetPosition(point), time_s});
  }
  return track;
}

kg_msgs::NavGraph ToMessage(const kg_engine::AgentGraph& made) {
  const NavGraph& graph = *made.graph;
  kg_msgs::NavGraph message;
  message.header.stamp = ToRosTime(made.made_s);
  message.world_version = made.world_version;
  message.cycle = made.cycle;
  message.agent = made.agent;
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
  for (std::size_t i = 0; i < made.staging.size(); ++i) {
    message.edges[i].staging = made.staging[i];
  }
  for (const TraverseEdge& edge : graph.inner_edges) {
    message.edges.push_back(ToMessage(edge));
    message.edges.back().within_window = true;
  }
  return message;
}

kg_engine::AgentGraph FromMessage(const kg_msgs::NavGraph& message) {
  kg_engine::AgentGraph made;
  made.made_s = FromRosTime(message.header.stamp);
  made.world_version = message.world_version;
  made.cycle = message.cycle;
  made.agent = message.agent;
  NavGraph graph;
  graph.agent_iri = message.agent_iri;
  graph.window = message.window;
  graph.hash = message.hash;
  graph.movement_mode = kg_compiler::MovementModeOf(message.movement_mode);
  for (const kg_msgs::Waypoint& waypoint : message.waypoints) {
    if (waypoint.id != graph.waypoints.size() ||
        !std::isfinite(waypoint.score)) {
      throw kg_base::InputError("NavGraph of " + message.agent + ", window " +
                                std::to_string(message.window) +
                                ": waypoints must be numbered from 0 and "
                                "scores finite");
    }
    graph.waypoints.push_back(FromMessage(waypoint));
  }
  for (const kg_msgs::TraverseEdge& edge : message.edges) {
    if (!IsJoined(edge, message.waypoints.size()) ||
        !std::isfinite(edge.cost.seam_cost)) {
      throw kg_base::InputError("NavGraph of " + message.agent + ", window " +
                                std::to_string(message.window) +
                                ": edges must lead to its waypoints, by way "
                                "of its waypoints, and costs be finite");
    }
    // `staging` is indexed by graph.edges only; inner edges have no flag.
    auto& edges = edge.within_window ? graph.inner_edges : graph.edges;
    edges.push_back(FromMessage(edge));
    if (!edge.within_window) made.staging.push_back(edge.staging);
  }
  made.graph = std::make_shared<const NavGraph>(std::move(graph));
  return made;
}

kg_msgs::Pathlet ToMessage(const kg_selector::Pathlet& pathlet) {
  kg_msgs::Pathlet message;
  message.rank = pathlet.rank;
  message.reward = pathlet.reward;
  message.seam_cost = pathlet.seam_cost;
  message.energy_j = pathlet.energy_j;
  for (const kg_selector::Visit& visit : pathlet.visits) {
    message.visits.push_back(ToMessage(visit));
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

kg_msgs::Candidates ToMessage(const kg_selector::AgentCandidates& candidates) {
  kg_msgs::Candidates message;
  message.header.stamp = ToRosTime(candidates.time_s);
  message.world_version = candidates.world_version;
  message.cycle = candidates.cycle;
  message.agent = candidates.agent;
  message.agent_iri = candidates.agent_iri;
  message.round = candidates.round;
  for (const kg_selector::Pathlet& pathlet : candidates.found.pathlets) {
    message.pathlets.push_back(ToMessage(pathlet));
  }
  message.proven = candidates.found.proven;
  message.bound = FiniteOrUnknown(candidates.found.bound);
  message.note = candidates.found.note;
  message.stages = ToMessage(candidates.stages);
  return message;
}

kg_selector::AgentCandidates FromMessage(const kg_msgs::Candidates& message) {
  kg_selector::AgentCandidates candidates;
  candidates.time_s = FromRosTime(message.header.stamp);
  candidates.world_version = message.world_version;
  candidates.cycle = message.cycle;
  candidates.agent = message.agent;
  candidates.agent_iri = message.agent_iri;
  candidates.round = message.round;
  kg_selector::AgentOffer& found = candidates.found;
  for (const kg_msgs::Pathlet& pathlet : message.pathlets) {
    found.pathlets.push_back(FromMessage(pathlet, message.agent));
  }
  found.proven = message.proven;
  found.note = message.note;
  found.bound = message.bound;
  if (found.pathlets.empty() && message.proven) {
    // No path: restore the planner's bound of -infinity, sent as NaN.
    found.bound = -std::numeric_limits<double>::infinity();
  }
  return candidates;
}

kg_msgs::RoundRequest ToMessage(const kg_selector::RoundRequest& request) {
  kg_msgs::RoundRequest message;
  SetHeader(request, &message);
  message.round = request.round;
  message.asked = request.asked;
  for (const auto& one : request.cooling) {
    message.cooling.push_back(ToMessage(one));
  }
  for (const auto& one : request.prices) {
    message.prices.push_back(ToMessage(one));
  }
  return message;
}

kg_selector::RoundRequest FromMessage(const kg_msgs::RoundRequest& message) {
  auto request = FromHeader<kg_selector::RoundRequest>(message);
  request.round = message.round;
  request.asked = message.asked;
  for (const kg_msgs::Cooling& one : message.cooling) {
    request.cooling.push_back(FromMessage(one));
  }
  for (const kg_msgs::Price& one : message.prices) {
    request.prices.push_back(FromMessage(one));
  }
  return request;
}

kg_msgs::Rejections ToMessage(const kg_selector::RunEnd& end) {
  kg_msgs::Rejections message;
  SetHeader(end, &message);
  for (const auto& one : end.rejections) {
    message.rejections.push_back(ToMessage(one));
  }
  return message;
}

kg_selector::RunEnd FromMessage(const kg_msgs::Rejections& message) {
  auto end = FromHeader<kg_selector::RunEnd>(message);
  for (const kg_msgs::Rejection& one : message.rejections) {
    end.rejections.push_back(FromMessage(one));
  }
  return end;
}

kg_msgs::Assignments ToMessage(const kg_selector::CommittedPlan& plan) {
  kg_msgs::Assignments message;
  SetHeader(plan, &message);
  message.rounds = plan.rounds;
  message.reward = plan.reward;
  message.seam_cost = plan.seam_cost;
  message.bound = FiniteOrUnknown(plan.bound);
  message.mode = plan.mode;
  message.stability = plan.stability;
  message.displacement_m = plan.displacement_m;
  for (const kg_selector::PathAssignment& assignment : plan.assignments) {
    message.assignments.emplace_back();
    message.assignments.back().agent = assignment.pathlet.agent;
    message.assignments.back().agent_iri = assignment.agent_iri;
    message.assignments.back().pathlet = ToMessage(assignment.pathlet);
  }
  message.unassigned = kg_selector::UnassignedLines(plan);
  message.stages = ToMessage(plan.stages);
  return message;
}

kg_selector::CommittedPlan FromMessage(const kg_msgs::Assignments& message) {
  auto plan = FromHeader<kg_selector::CommittedPlan>(message);
  plan.rounds = static_cast<int>(message.rounds);
  plan.reward = message.reward;
  plan.seam_cost = message.seam_cost;
  plan.bound = message.bound;
  plan.mode = message.mode;
  plan.stability = message.stability;
  plan.displacement_m = message.displacement_m;
  for (const kg_msgs::Assignment& assignment : message.assignments) {
    plan.assignments.push_back(
        {assignment.agent_iri,
         FromMessage(assignment.pathlet, assignment.agent)});
  }
  for (const std::string& line : message.unassigned) {
    AddUnassigned(line, &plan);
  }
  for (const kg_msgs::StageTime& stage : message.stages) {
    plan.stages.push_back({stage.stage, stage.seconds, stage.count});
  }
  return plan;
}

}  // namespace kg_ros
