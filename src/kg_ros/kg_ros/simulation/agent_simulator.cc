#include "kg_ros/simulation/agent_simulator.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kg_core/geo/geodesy.h"
#include "kg_ros/conversion/message_units.h"
#include "kg_ros/conversion/plan_conversion.h"

namespace kg_ros {
namespace {

constexpr double kLookAhead_s = 600.0;  // For heading and speed.
constexpr double kOvershoot_s = 1.0;    // Real time a plan may begin ago.

}  // namespace

void AgentSimulator::Take(const kg_msgs::World& message) {
  world_ = message;
  time_s_ = std::max(time_s_, FromRosTime(message.mission_time));
}

void AgentSimulator::Take(const kg_msgs::Assignments& message) {
  plan_run_ = message.plan_run;
  const double overshoot_s = kOvershoot_s * rate_;
  for (const kg_msgs::Assignment& assignment : message.assignments) {
    Agent& agent = agents_[assignment.agent];
    agent.track = FromMessage(assignment.pathlet.track);
    agent.visits = assignment.pathlet.visits;
    if (agent.track.empty()) continue;
    const double begin_s = agent.track.front().time_s;
    if (begin_s < time_s_ && time_s_ - begin_s < overshoot_s) time_s_ = begin_s;
  }
}

void AgentSimulator::Take(const kg_msgs::SeamRules& message) {
  Agent& agent = agents_[message.agent];
  agent.energy_j = message.energy_budget_j;
  agent.has_energy = true;
}

std::vector<std::string> AgentSimulator::agents() const {
  std::vector<std::string> ids;
  for (const kg_msgs::AgentInfo& info : world_.agents) ids.push_back(info.id);
  return ids;
}

bool AgentSimulator::MayGoOn() const {
  const bool has_plan = world_.plan_status == kg_msgs::World::PLAN_OK ||
                        world_.plan_status == kg_msgs::World::PLAN_FAILED;
  const bool has_tracks_of_it = plan_run_ >= world_.plan_run;
  return has_plan && has_tracks_of_it && time_s_ < Limit_s();
}

// The end of the window the world is in.
double AgentSimulator::Limit_s() const {
  const auto window = static_cast<std::size_t>(world_.current_window);
  if (window >= world_.windows.size()) return time_s_;
  return FromRosTime(world_.windows[window].end);
}

std::vector<kg_msgs::AgentState> AgentSimulator::Advance(const double real_s) {
  if (!MayGoOn()) return {};
  time_s_ = std::min(Limit_s(), time_s_ + rate_ * real_s);
  std::vector<kg_msgs::AgentState> states;
  for (const auto& [id, agent] : agents_) {
    if (!agent.track.empty()) states.push_back(StateOf(id, agent));
  }
  return states;
}

// Steady within each window between a seam's departure and the window's end:
// good enough for a gauge; what counts is the sum at the windows' borders.
double AgentSimulator::EnergyUsed_j(const Agent& agent) const {
  double used_j = 0.0;
  double begin_s = FromRosTime(ToRosTime(agent.track.front().time_s));
  for (const kg_msgs::Visit& visit : agent.visits) {
    if (visit.window >= static_cast<int>(world_.windows.size())) break;
    const double end_s = FromRosTime(world_.windows[visit.window].end);
    const double share = (time_s_ - begin_s) / (end_s - begin_s);
    used_j += std::clamp(share, 0.0, 1.0) * visit.cost.energy_j;
    begin_s = end_s;
  }
  return used_j;
}

kg_msgs::AgentState AgentSimulator::StateOf(const std::string& id,
                                            const Agent& agent) const {
  const kg_core::LonLat here = PositionAt(agent.track, time_s_);
  const kg_core::LonLat ahead = PositionAt(agent.track, time_s_ + kLookAhead_s);
  kg_msgs::AgentState state;
  state.header.stamp = ToRosTime(time_s_);
  state.agent = id;
  SetPosition(here, &state);
  const double way_m = kg_core::Distance_m(here, ahead);
  state.speed_mps = way_m / kLookAhead_s;
  state.heading_rad = way_m > 1.0 ? kg_core::Bearing_rad(here, ahead) : 0.0;
  state.energy_left_j =
      agent.has_energy ? std::max(0.0, agent.energy_j - EnergyUsed_j(agent))
                       : std::numeric_limits<double>::quiet_NaN();
  return state;
}

}  // namespace kg_ros
