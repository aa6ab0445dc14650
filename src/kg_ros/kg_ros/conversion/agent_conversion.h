// Reports of agents, and the world as read by the simulation.

#ifndef KG_ROS_CONVERSION_AGENT_CONVERSION_H_
#define KG_ROS_CONVERSION_AGENT_CONVERSION_H_

#include "kg_engine/simulation/agent_simulator.h"
#include "kg_engine/state/fleet_state.h"
#include "kg_msgs/AgentState.h"
#include "kg_msgs/World.h"

namespace kg_ros {

// Unchecked: FleetState::Observe checks the numbers.
kg_engine::AgentPose FromMessage(const kg_msgs::AgentState& message);
kg_msgs::AgentState ToMessage(const kg_engine::SimulatedState& state);

kg_engine::SimulatedWorld FromMessage(const kg_msgs::World& message);

}  // namespace kg_ros

#endif  // KG_ROS_CONVERSION_AGENT_CONVERSION_H_
