// Answers kg/why on its own thread, in parallel to updates and cycles.
//
// Tensor cells are answered from the newest compilation; the rest from the last
// committed plan, even if stale, which the text then states.

#ifndef KG_ROS_KNOWLEDGE_WHY_SERVER_H_
#define KG_ROS_KNOWLEDGE_WHY_SERVER_H_

#include "kg_engine/server/plan_archive.h"
#include "kg_msgs/Why.h"
#include "ros/callback_queue.h"
#include "ros/node_handle.h"
#include "ros/service_server.h"
#include "ros/spinner.h"

namespace kg_engine {
class MissionServer;
}

namespace kg_ros {

class WhyServer {
 public:
  // `server` must outlive this object; only its Read() is used.
  WhyServer(const ros::NodeHandle& node,
            const kg_engine::MissionServer* server);
  ~WhyServer();
  WhyServer(const WhyServer&) = delete;
  WhyServer& operator=(const WhyServer&) = delete;

  kg_engine::PlanArchive& archive() { return archive_; }

 private:
  bool Handle(kg_msgs::Why::Request& request, kg_msgs::Why::Response& response);

  kg_engine::PlanArchive archive_;
  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  const kg_engine::MissionServer* server_;
  ros::ServiceServer service_;
  ros::AsyncSpinner spinner_;
};

}  // namespace kg_ros

#endif  // KG_ROS_KNOWLEDGE_WHY_SERVER_H_
