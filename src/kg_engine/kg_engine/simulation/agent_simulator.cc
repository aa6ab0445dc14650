#include "kg_engine/simulation/agent_simulator.h"

#include <algorithm>
#include <cmath>

#include "kg_base/geo/geodesy.h"
#include "kg_engine/simulation/track_position.h"

namespace kg_engine {
namespace {

constexpr double kLookAhead_s = 600.0;  // Look-ahead for heading and speed.
constexpr double kOvershoot_s = 1.0;  // Maximum real time since a plan's begin.

}  // namespace

void AgentSimulator::Take(const SimulatedWorld& world) {
  world_ = world;
  time_s_ = std::max(time_s_, world.time_s);
}

void AgentSimulator::Take(const kg_selector::CommittedPlan& plan) {
  plan_run_ = plan.run;
  const double overshoot_s = kOvershoot_s * rate_;
  for (const kg_selector::PathAssignment& assignment : plan.assignments) {
    Agent& agent = agents_[assignment.pathlet.agent];
    agent.track = assignment.pathlet.track;
    agent.visits = assignment.pathlet.visits;
    if (agent.track.empty()) continue;
    const double begin_s = agent.track.front().time_s;
    if (begin_s < time_s_ && time_s_ - begin_s < overshoot_s) time_s_ = begin_s;
  }
}

void AgentSimulator::TakeEnergy(const std::string& agent,
                                const double energy_j) {
  agents_[agent].energy_j = energy_j;
  agents_[agent].has_energy = true;
}

bool AgentSimulator::MayGoOn() const {
  const bool has_tracks_of_it = plan_run_ >= world_.plan_run;
  return world_.plan_holds && has_tracks_of_it && time_s_ < Limit_s();
}

// End of the current window.
double AgentSimulator::Limit_s() const {
  if (world_.current_window >= world_.window_end_s.size()) return time_s_;
  return world_.window_end_s[world_.current_window];
}

std::vector<SimulatedState> AgentSimulator::Advance(const double real_s) {
  if (!MayGoOn()) return {};
  time_s_ = std::min(Limit_s(), time_s_ + rate_ * real_s);
  std::vector<SimulatedState> states;
  for (const auto& [id, agent] : agents_) {
    if (!agent.track.empty()) states.push_back(StateOf(id, agent));
  }
  return states;
}

// Linear within each window between a seam's departure and the window's end:
// accurate enough for a gauge; only the sum at window ends matters.
double AgentSimulator::EnergyUsed_j(const Agent& agent) const {
  double used_j = 0.0;
  double begin_s = agent.track.front().time_s;
  for (const kg_selector::Visit& visit : agent.visits) {
    if (visit.window >= static_cast<int>(world_.window_end_s.size())) break;
    const double end_s = world_.window_end_s[visit.window];
    const double share = (time_s_ - begin_s) / (end_s - begin_s);
    used_j += std::clamp(share, 0.0, 1.0) * visit.cost.energy_j;
    begin_s = end_s;
  }
  return used_j;
}

SimulatedState AgentSimulator::StateOf(const std::string& id,
                                       const Agent& agent) const {
  const kg_base::LonLat ahead = PositionAt(agent.track, time_s_ + kLookAhead_s);
  SimulatedState state;
  state.agent = id;
  state.time_s = time_s_;
  state.position = PositionAt(agent.track, time_s_);
  const double way_m = kg_base::Distance_m(state.position, ahead);
  state.speed_mps = way_m / kLookAhead_s;
  state.heading_rad =
      way_m > 1.0 ? kg_base::Bearing_rad(state.position, ahead) : 0.0;
  if (agent.has_energy) {
    state.energy_left_j = std::max(0.0, agent.energy_j - EnergyUsed_j(agent));
  }
  return state;
}

}  // namespace kg_engine
