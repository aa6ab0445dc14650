#include "kg_ros/simulation/agent_sim_node.h"

int main(int argc, char** argv) { return kg_ros::RunAgentSimNode(argc, argv); }
