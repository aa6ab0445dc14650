// Answers kg/query and kg/export on their own threads, from snapshots of the
// store, in parallel to updates and cycles; a slow query does not delay them.

#ifndef KG_ROS_KNOWLEDGE_QUERY_SERVER_H_
#define KG_ROS_KNOWLEDGE_QUERY_SERVER_H_

#include <vector>

#include "kg_core/rdf/store.h"
#include "kg_msgs/Query.h"
#include "ros/callback_queue.h"
#include "ros/node_handle.h"
#include "ros/service_server.h"
#include "ros/spinner.h"

namespace kg_engine {
class MissionServer;
}

namespace kg_ros {

class QueryServer {
 public:
  // `server` must outlive this object; only its Read() is used.
  QueryServer(const ros::NodeHandle& node,
              const kg_engine::MissionServer* server);
  ~QueryServer();
  QueryServer(const QueryServer&) = delete;
  QueryServer& operator=(const QueryServer&) = delete;

 private:
  bool HandleQuery(kg_msgs::Query::Request& request,
                   kg_msgs::Query::Response& response);

  ros::CallbackQueue query_queue_;
  ros::CallbackQueue queue_;
  ros::NodeHandle query_node_;
  ros::NodeHandle node_;
  const kg_engine::MissionServer* server_;
  std::vector<ros::ServiceServer> services_;
  ros::AsyncSpinner query_spinner_;
  ros::AsyncSpinner spinner_;
};

}  // namespace kg_ros

#endif  // KG_ROS_KNOWLEDGE_QUERY_SERVER_H_
