// kg/watch and kg/watched: publishes changes of a query's answer, whatever
// caused them. Evaluates snapshots on its own threads, so that neither the
// writer nor kg/query waits for it. Of changes in quick succession only the
// last state is published, and that one always.

#ifndef KG_ROS_KNOWLEDGE_WATCH_SERVER_H_
#define KG_ROS_KNOWLEDGE_WATCH_SERVER_H_

#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "kg_core/rdf/graph_view.h"
#include "kg_core/watch/watch_list.h"
#include "kg_msgs/Watch.h"
#include "ros/callback_queue.h"
#include "ros/node_handle.h"
#include "ros/publisher.h"
#include "ros/service_server.h"
#include "ros/spinner.h"

namespace kg_engine {
class MissionServer;
}

namespace kg_ros {

class WatchServer {
 public:
  // Resumes the watches kept in the store. `server` must outlive this object;
  // only its thread-safe functions are used.
  WatchServer(const ros::NodeHandle& node, kg_engine::MissionServer* server);
  ~WatchServer();
  WatchServer(const WatchServer&) = delete;
  WatchServer& operator=(const WatchServer&) = delete;

 private:
  bool HandleWatch(kg_msgs::Watch::Request& request,
                   kg_msgs::Watch::Response& response);
  void Cancel(const std::string& id, kg_msgs::Watch::Response* response);
  void Begin(const kg_core::WatchDefinition& definition,
             kg_msgs::Watch::Response* response);
  void Run();
  void LookAtAll();
  void LookAt(const std::string& id);
  // Sleeps for `seconds`, or until shutdown.
  bool RestFor(double seconds);

  kg_engine::MissionServer* const server_;
  std::mutex list_mutex_;  // Held while one query runs.
  kg_core::WatchList list_;
  std::mutex end_mutex_;
  std::condition_variable end_changed_;
  bool is_ending_ = false;

  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  ros::Publisher watched_;
  ros::ServiceServer service_;
  ros::AsyncSpinner spinner_;
  std::thread looker_;
};

}  // namespace kg_ros

#endif  // KG_ROS_KNOWLEDGE_WATCH_SERVER_H_
