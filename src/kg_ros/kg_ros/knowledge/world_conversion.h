// The world in one message: version, windows, agents, time.

#ifndef KG_ROS_KNOWLEDGE_WORLD_CONVERSION_H_
#define KG_ROS_KNOWLEDGE_WORLD_CONVERSION_H_

#include "kg_compiler/compile/mission_compiler.h"
#include "kg_msgs/World.h"
#include "kg_ros/knowledge/mission_server.h"

namespace kg_ros {

// All but header and plan. `compilation` (for the tensors' hashes) may be null.
kg_msgs::World DescribeWorld(const MissionServer& server,
                             const kg_compiler::Compilation* compilation);

}  // namespace kg_ros

#endif  // KG_ROS_KNOWLEDGE_WORLD_CONVERSION_H_
