#include "kg_ros/planning/planner_node.h"

int main(int argc, char** argv) { return kg_ros::RunPlannerNode(argc, argv); }
