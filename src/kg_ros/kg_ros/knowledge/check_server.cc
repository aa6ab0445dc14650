#include "kg_ros/knowledge/check_server.h"

#include "kg_engine/server/mission_server.h"
#include "kg_engine/server/world_check.h"
#include "kg_ros/base/names.h"
#include "kg_ros/conversion/answer_conversion.h"
#include "ros/console.h"

namespace kg_ros {

CheckServer::CheckServer(const ros::NodeHandle& node,
                         kg_engine::MissionServer* server)
    : node_(node), server_(server), spinner_(1, &queue_) {
  node_.setCallbackQueue(&queue_);
  service_ = node_.advertiseService(kCheckService, &CheckServer::Handle, this);
  spinner_.start();
}

CheckServer::~CheckServer() { spinner_.stop(); }

bool CheckServer::Handle(kg_msgs::Check::Request&,
                         kg_msgs::Check::Response& response) {
  response =
      ToMessage(kg_engine::CheckWorld(server_->present(), server_->files()));
  if (response.ok) {
    ROS_INFO_STREAM("[check] world version " << response.world_version << ": "
                                             << response.text);
  } else {
    ROS_WARN_STREAM("[check] world version " << response.world_version << ": "
                                             << response.text);
  }
  return true;
}

}  // namespace kg_ros
