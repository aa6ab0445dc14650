// agent_sim_node: plays the mission: agents follow their assigned tracks.
//
//   parameters  ~rate  mission hours per real second

#ifndef KG_ROS_SIMULATION_AGENT_SIM_NODE_H_
#define KG_ROS_SIMULATION_AGENT_SIM_NODE_H_

namespace kg_ros {

// The main program. Returns EXIT_FAILURE after bad parameters, with a log line.
int RunAgentSimNode(int argc, char** argv);

}  // namespace kg_ros

#endif  // KG_ROS_SIMULATION_AGENT_SIM_NODE_H_
