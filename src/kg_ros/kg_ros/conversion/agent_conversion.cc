#include "kg_ros/conversion/agent_conversion.h"

#include "kg_ros/conversion/message_units.h"

namespace kg_ros {

kg_engine::AgentPose FromMessage(const kg_msgs::AgentState& message) {
  kg_engine::AgentPose pose;
  pose.position = GetPosition(message);
  pose.heading_rad = message.heading_rad;
  pose.time_s = FromRosTime(message.header.stamp);
  pose.energy_left_j = message.energy_left_j;
  return pose;
}

kg_msgs::AgentState ToMessage(const kg_engine::SimulatedState& state) {
  kg_msgs::AgentState message;
  message.header.stamp = ToRosTime(state.time_s);
  message.agent = state.agent;
  SetPosition(state.position, &message);
  message.speed_mps = state.speed_mps;
  message.heading_rad = state.heading_rad;
  message.energy_left_j = state.energy_left_j;
  return message;
}

kg_engine::SimulatedWorld FromMessage(const kg_msgs::World& message) {
  kg_engine::SimulatedWorld world;
  world.time_s = FromRosTime(message.mission_time);
  world.plan_holds = message.plan_status == kg_msgs::World::PLAN_OK ||
                     message.plan_status == kg_msgs::World::PLAN_FAILED;
  world.plan_run = message.plan_run;
  world.current_window = static_cast<std::size_t>(message.current_window);
  for (const kg_msgs::WindowInfo& window : message.windows) {
    world.window_end_s.push_back(FromRosTime(window.end));
  }
  for (const kg_msgs::AgentInfo& agent : message.agents) {
    world.agents.push_back(agent.id);
  }
  return world;
}

}  // namespace kg_ros
