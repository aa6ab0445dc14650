// Answers kg/what_if on its own thread, one question at a time, in parallel to
// updates and cycles.

#ifndef KG_ROS_KNOWLEDGE_WHAT_IF_SERVER_H_
#define KG_ROS_KNOWLEDGE_WHAT_IF_SERVER_H_

#include "kg_engine/what_if/what_if.h"
#include "kg_msgs/WhatIf.h"
#include "ros/callback_queue.h"
#include "ros/node_handle.h"
#include "ros/service_server.h"
#include "ros/spinner.h"

namespace kg_engine {
class MissionServer;
}

namespace kg_ros {

class WhatIfServer {
 public:
  // `server` must outlive this object; only present() and files() are used.
  WhatIfServer(const ros::NodeHandle& node, kg_engine::MissionServer* server);
  ~WhatIfServer();
  WhatIfServer(const WhatIfServer&) = delete;
  WhatIfServer& operator=(const WhatIfServer&) = delete;

 private:
  bool Handle(kg_msgs::WhatIf::Request& request,
              kg_msgs::WhatIf::Response& response);

  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  const kg_engine::MissionServer* server_;
  kg_engine::WhatIf what_if_;
  ros::ServiceServer service_;
  ros::AsyncSpinner spinner_;
};

}  // namespace kg_ros

#endif  // KG_ROS_KNOWLEDGE_WHAT_IF_SERVER_H_
