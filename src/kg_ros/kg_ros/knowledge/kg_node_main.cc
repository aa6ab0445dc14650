#include "kg_ros/knowledge/run_kg_node.h"

int main(int argc, char** argv) { return kg_ros::RunKgNode(argc, argv); }
