// planner_node: plans for one agent. It converts, calls and publishes; every
// decision is made in the libraries.
//
//   parameters  ~agent  the agent's ex:id

#ifndef KG_ROS_PLANNING_PLANNER_NODE_H_
#define KG_ROS_PLANNING_PLANNER_NODE_H_

namespace kg_ros {

// The main program. Returns EXIT_FAILURE after bad parameters, with a log line.
int RunPlannerNode(int argc, char** argv);

}  // namespace kg_ros

#endif  // KG_ROS_PLANNING_PLANNER_NODE_H_
