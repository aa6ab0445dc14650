#include "kg_ros/knowledge/run_kg_node.h"

#include "kg_base/common/input_error.h"
#include "kg_ros/base/parameter_reader.h"
#include "kg_ros/base/run_node.h"
#include "kg_ros/knowledge/kg_node.h"
#include "ros/init.h"
#include "ros/package.h"

namespace kg_ros {
namespace {

constexpr double kRetry_s = 10.0;
constexpr double kPoll_s = 0.1;

struct Parameters {
  kg_engine::MissionFolders folders;
  kg_engine::SparqlHttpOptions http;
};

Parameters ReadParameters(const ros::NodeHandle& own) {
  ParameterReader read(own);
  Parameters parameters;
  kg_engine::MissionFolders& folders = parameters.folders;
  folders.mission = read.Text("mission_folder");
  folders.data = read.Text("data_folder", "");
  folders.state = read.Text("state_folder");
  folders.ontology = ros::package::getPath("kg_mission") + "/ontology";
  // Re-read while the node runs.
  read.Integer("view_window", {-1, 100000}, -1);
  parameters.http.port = read.Integer("http_port", {0, 65535}, 0);
  parameters.http.token_file = read.Text("http_token_file", "");
  parameters.http.writable = read.Boolean("http_writable", false);
  read.RefuseTheRest();
  return parameters;
}

// Retries with a log message if the mission cannot be opened, because its files
// may still be arriving.
void Serve(const Parameters& parameters, const ros::NodeHandle& own) {
  while (ros::ok()) {
    try {
      KgNode node(parameters.folders, parameters.http, ros::NodeHandle(), own);
      node.Spin();
      return;
    } catch (const kg_base::InputError& error) {
      ROS_FATAL_STREAM("[facts] " << error.what());
    }
    const ros::SteadyTime again =
        ros::SteadyTime::now() + ros::WallDuration(kRetry_s);
    while (ros::ok() && ros::SteadyTime::now() < again) {
      ros::WallDuration(kPoll_s).sleep();
    }
  }
}

}  // namespace

int RunKgNode(int argc, char** argv) {
  return RunNode(argc, argv, "kg", [](const ros::NodeHandle& own) {
    Serve(ReadParameters(own), own);
  });
}

}  // namespace kg_ros
