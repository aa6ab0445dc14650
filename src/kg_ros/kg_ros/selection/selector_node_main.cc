#include "kg_ros/selection/selector_node.h"

int main(int argc, char** argv) { return kg_ros::RunSelectorNode(argc, argv); }
