// State of the world as one message: version, windows, agents, time.

#ifndef KG_ROS_CONVERSION_WORLD_CONVERSION_H_
#define KG_ROS_CONVERSION_WORLD_CONVERSION_H_

#include "kg_compiler/compile/mission_compiler.h"
#include "kg_engine/server/mission_server.h"
#include "kg_msgs/World.h"

namespace kg_ros {

// All fields but header and plan. `compilation` (for the tensors' hashes) may
// be null.
kg_msgs::World DescribeWorld(const kg_engine::MissionServer& server,
                             const kg_compiler::Compilation* compilation);

}  // namespace kg_ros

#endif  // KG_ROS_CONVERSION_WORLD_CONVERSION_H_
