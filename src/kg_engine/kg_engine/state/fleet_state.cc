#include "kg_engine/state/fleet_state.h"

#include <algorithm>
#include <cmath>

namespace kg_engine {
namespace {

AgentPose StartPose(const kg_mission::Mission& mission,
                    const kg_mission::Agent& agent) {
  return {agent.start, agent.start_heading_rad, mission.windows.front().begin_s,
          agent.capabilities.energy_budget_j, false};
}

bool IsUsable(const AgentPose& pose) {
  return std::isfinite(pose.position.lon_deg) &&
         std::abs(pose.position.lat_deg) <= 90.0 &&
         std::isfinite(pose.heading_rad) && std::isfinite(pose.time_s) &&
         !std::isinf(pose.energy_left_j);
}

}  // namespace

void FleetState::Reset(const kg_mission::Mission& mission) {
  poses_.clear();
  time_s_ = mission.windows.front().begin_s;
  Follow(mission);
}

void FleetState::Restore(const std::map<std::string, AgentPose>& poses,
                         const double time_s) {
  poses_ = poses;
  time_s_ = time_s;
}

bool FleetState::Observe(const std::string& agent_id, const AgentPose& pose) {
  const auto found = poses_.find(agent_id);
  if (found == poses_.end() || !IsUsable(pose)) return false;
  time_s_ = std::max(time_s_, pose.time_s);
  if (pose.time_s < found->second.time_s) return true;
  const double energy_before_j = found->second.energy_left_j;
  found->second = pose;
  found->second.observed = true;
  if (std::isnan(pose.energy_left_j)) {
    found->second.energy_left_j = energy_before_j;
  }
  return true;
}

void FleetState::Follow(const kg_mission::Mission& mission) {
  std::map<std::string, AgentPose> poses;
  for (const kg_mission::Agent& agent : mission.agents) {
    const auto known = poses_.find(agent.id);
    poses[agent.id] = known == poses_.end() || !known->second.observed
                          ? StartPose(mission, agent)
                          : known->second;
  }
  poses_ = std::move(poses);
}

std::string FleetState::Clock() const {
  for (const auto& [agent, pose] : poses_) {
    if (pose.observed && pose.time_s >= time_s_) return agent;
  }
  return "";
}

bool FleetState::IsComplete() const {
  return std::all_of(poses_.begin(), poses_.end(), [this](const auto& entry) {
    return entry.second.time_s >= time_s_;
  });
}

int FleetState::CurrentWindow(const kg_mission::Mission& mission) const {
  int window = 0;
  for (const kg_mission::TimeWindow& candidate : mission.windows) {
    if (time_s_ >= candidate.end_s) window = candidate.index + 1;
  }
  return window;
}

}  // namespace kg_engine
