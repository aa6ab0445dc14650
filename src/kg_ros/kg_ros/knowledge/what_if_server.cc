#include "kg_ros/knowledge/what_if_server.h"

#include "kg_engine/server/mission_server.h"
#include "kg_ros/base/names.h"
#include "kg_ros/conversion/answer_conversion.h"
#include "ros/console.h"

namespace kg_ros {

WhatIfServer::WhatIfServer(const ros::NodeHandle& node,
                           kg_engine::MissionServer* server)
    : node_(node),
      server_(server),
      what_if_(server->files()),
      spinner_(1, &queue_) {
  node_.setCallbackQueue(&queue_);
  service_ =
      node_.advertiseService(kWhatIfService, &WhatIfServer::Handle, this);
  spinner_.start();
}

WhatIfServer::~WhatIfServer() { spinner_.stop(); }

bool WhatIfServer::Handle(kg_msgs::WhatIf::Request& request,
                          kg_msgs::WhatIf::Response& response) {
  const ros::WallTime begin = ros::WallTime::now();
  response = ToMessage(what_if_.Ask(server_->present(), FromMessage(request)));
  response.plan.header.stamp = ros::Time::now();
  ROS_INFO("[what if] world version %lu, %s: %zu artifacts dirty, %.3f s",
           response.world_version, response.ok ? "answered" : "refused",
           response.dirty.size(), (ros::WallTime::now() - begin).toSec());
  return true;
}

}  // namespace kg_ros
