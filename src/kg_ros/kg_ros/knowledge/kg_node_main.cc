// kg_node: owns the mission's facts, compiles them, records the plans.
//
//   parameters  ~mission_folder  holds mission.ttl
//               ~data_folder     folder searched first for its files
//               ~state_folder    the durable store
//               ~view_window     window rviz looks at; -1 = the current one
//               ~http_port       SPARQL over HTTP on 127.0.0.1; 0 = off
//               ~http_token_file holds the access token; "" = none is asked
//               ~http_writable   true = accept updates over HTTP; needs a token

#include <cstdlib>

#include "kg_base/common/input_error.h"
#include "kg_ros/base/parameter_reader.h"
#include "kg_ros/knowledge/kg_node.h"
#include "ros/init.h"
#include "ros/package.h"

namespace {

constexpr double kRetry_s = 10.0;
constexpr double kPoll_s = 0.1;

struct Parameters {
  kg_engine::MissionFolders folders;
  kg_engine::SparqlHttpOptions http;
};

Parameters ReadParameters(const ros::NodeHandle& own) {
  kg_ros::ParameterReader read(own);
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
      kg_ros::KgNode node(parameters.folders, parameters.http,
                          ros::NodeHandle(), own);
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

int main(int argc, char** argv) {
  ros::init(argc, argv, "kg");
  const ros::NodeHandle own("~");  // Must outlive the last log line.
  try {
    Serve(ReadParameters(own), own);
    return EXIT_SUCCESS;
  } catch (const kg_base::InputError& error) {
    ROS_FATAL_STREAM(error.what());
    return EXIT_FAILURE;
  }
}
