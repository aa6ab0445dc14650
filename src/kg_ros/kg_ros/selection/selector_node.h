// selector_node: makes one conflict-free team plan from all agents' candidates.
// It converts, calls and publishes; every decision is made in the libraries.
//
// A planner's death is noticed by its connection: the subscription of a planner
// node to the requests ends with its process. Which agent a node plans for is
// its parameter ~agent.
//
//   parameters  ~deadline_s  maximum wait for a missing planner [s]

#ifndef KG_ROS_SELECTION_SELECTOR_NODE_H_
#define KG_ROS_SELECTION_SELECTOR_NODE_H_

namespace kg_ros {

// The main program. Returns EXIT_FAILURE after bad parameters, with a log line.
int RunSelectorNode(int argc, char** argv);

}  // namespace kg_ros

#endif  // KG_ROS_SELECTION_SELECTOR_NODE_H_
