// Answers kg/check on its own thread, in parallel to updates and cycles.

#ifndef KG_ROS_KNOWLEDGE_CHECK_SERVER_H_
#define KG_ROS_KNOWLEDGE_CHECK_SERVER_H_

#include "kg_msgs/Check.h"
#include "ros/callback_queue.h"
#include "ros/node_handle.h"
#include "ros/service_server.h"
#include "ros/spinner.h"

namespace kg_engine {
class MissionServer;
}

namespace kg_ros {

class CheckServer {
 public:
  // `server` must outlive this object; only present() and files() are used.
  CheckServer(const ros::NodeHandle& node, kg_engine::MissionServer* server);
  ~CheckServer();
  CheckServer(const CheckServer&) = delete;
  CheckServer& operator=(const CheckServer&) = delete;

 private:
  bool Handle(kg_msgs::Check::Request& request,
              kg_msgs::Check::Response& response);

  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  kg_engine::MissionServer* server_;
  ros::ServiceServer service_;
  ros::AsyncSpinner spinner_;
};

}  // namespace kg_ros

#endif  // KG_ROS_KNOWLEDGE_CHECK_SERVER_H_
