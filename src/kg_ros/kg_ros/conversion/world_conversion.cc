#include "kg_ros/conversion/world_conversion.h"

#include "kg_ros/conversion/message_units.h"
#include "kg_ros/conversion/rules_conversion.h"

namespace kg_ros {
namespace {

kg_msgs::AgentInfo Describe(const kg_mission::Agent& agent,
                            const kg_engine::AgentPose& pose,
                            const kg_compiler::Compilation* compilation) {
  kg_msgs::AgentInfo info;
  info.id = agent.id;
  info.iri = agent.iri;
  info.policy = agent.policy.iri;
  SetPosition(pose.position, &info);
  info.heading_rad = pose.heading_rad;
  if (compilation == nullptr) return info;
  for (const auto& tensor : compilation->tensors) {
    if (tensor->agent_iri == agent.iri) {
      info.tensor_hash.push_back(tensor->hash);
    }
  }
  return info;
}

}  // namespace

kg_msgs::World DescribeWorld(const kg_engine::MissionServer& server,
                             const kg_compiler::Compilation* compilation) {
  const kg_mission::Mission& mission = server.mission();
  kg_msgs::World world;
  world.world_version = server.world_version();
  world.cycle = server.cycle();
  world.plan_run = server.plan_run();
  world.mission = mission.iri;
  world.mission_name = mission.name;
  world.mission_time = ToRosTime(server.fleet().time_s());
  world.current_window = server.current_window();
  for (const kg_mission::TimeWindow& window : mission.windows) {
    world.windows.push_back(ToMessage(window));
  }
  for (const kg_mission::Agent& agent : mission.agents) {
    world.agents.push_back(
        Describe(agent, server.fleet().poses().at(agent.id), compilation));
  }
  return world;
}

}  // namespace kg_ros
