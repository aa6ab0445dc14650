// Start-up and error handling shared by the main programs of all nodes.

#ifndef KG_ROS_BASE_RUN_NODE_H_
#define KG_ROS_BASE_RUN_NODE_H_

#include <functional>
#include <string>

#include "ros/node_handle.h"

namespace kg_ros {

// Initialises ROS under `name` and calls `run` with the handle of the node's
// own names ("~"). A kg_base::InputError that `run` throws becomes a fatal log
// line; EXIT_FAILURE is returned then, else EXIT_SUCCESS.
int RunNode(int argc, char** argv, const std::string& name,
            const std::function<void(const ros::NodeHandle& own)>& run);

}  // namespace kg_ros

#endif  // KG_ROS_BASE_RUN_NODE_H_
