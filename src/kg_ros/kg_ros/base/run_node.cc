#include "kg_ros/base/run_node.h"

#include <cstdlib>

#include "kg_base/common/input_error.h"
#include "ros/console.h"
#include "ros/init.h"

namespace kg_ros {

int RunNode(int argc, char** argv, const std::string& name,
            const std::function<void(const ros::NodeHandle& own)>& run) {
  ros::init(argc, argv, name);
  const ros::NodeHandle own("~");  // Must outlive the last log line.
  try {
    run(own);
    return EXIT_SUCCESS;
  } catch (const kg_base::InputError& error) {
    ROS_FATAL_STREAM(error.what());
    return EXIT_FAILURE;
  }
}

}  // namespace kg_ros
