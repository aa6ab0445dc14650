// Answers kg/why on a thread of its own, while the node goes on with facts and
// cycles.
//
// What an answer is made from is handed over as it comes to be: the compilation
// when a cycle begins, waypoint graphs as they arrive, the plan when it is
// committed. An answer is made from an immutable snapshot of that, of one world
// version; the graphs of a plan become one when it is first asked about.
//
// Tensor cells are answered from the newest compilation; the rest from the last
// committed plan, also while it is stale, which the text then says.

#ifndef KG_ROS_KNOWLEDGE_WHY_SERVER_H_
#define KG_ROS_KNOWLEDGE_WHY_SERVER_H_

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "kg_compiler/compile/mission_compiler.h"
#include "kg_core/rdf/graph_view.h"
#include "kg_msgs/NavGraph.h"
#include "kg_msgs/Why.h"
#include "kg_ros/knowledge/plan_facts.h"
#include "kg_selector/explain/explain_plan.h"
#include "kg_selector/explain/planned_world.h"
#include "ros/callback_queue.h"
#include "ros/node_handle.h"
#include "ros/service_server.h"
#include "ros/spinner.h"

namespace kg_ros {

// What is known of one planning cycle, without ROS topics; safe to use from
// several threads.
class PlanArchive {
 public:
  using World = std::shared_ptr<const kg_selector::PlannedWorld>;

  // `view` holds the facts that `compilation` was made from.
  void Begin(std::uint64_t cycle,
             std::shared_ptr<const kg_compiler::Compilation> compilation,
             std::shared_ptr<const kg_core::GraphView> view);
  // Ignored unless it is of the cycle that began last.
  void Take(const kg_msgs::NavGraph& graph);
  // The plan of the cycle that began last; `view` holds its facts, too.
  void Commit(const PlanRecord& record,
              std::shared_ptr<const kg_core::GraphView> view);

  // The newest compilation, perhaps without plan; null = there is none.
  World Newest() const;
  // The last committed plan; null = there is none.
  // Throws kg_core::InputError if the planners' graphs make no sense.
  World Planned() const;

 private:
  using Graphs = std::map<std::pair<std::string, int>,
                          std::shared_ptr<const kg_msgs::NavGraph>>;
  struct Cycle {
    std::uint64_t number = 0;
    std::shared_ptr<const kg_compiler::Compilation> compilation;
    std::shared_ptr<const kg_core::GraphView> view;
    Graphs graphs;  // By ex:id and window.
    std::shared_ptr<const PlanRecord> record;
  };
  static World Convert(const Cycle& cycle);

  mutable std::mutex mutex_;
  Cycle newest_;
  Cycle planned_;
  mutable World converted_;  // Of planned_; null = to be made.
};

// The question that a request asks.
kg_selector::PlanQuestion ToQuestion(const kg_msgs::Why::Request& request);

class MissionServer;

class WhyServer {
 public:
  // `server` must outlive this; only its Read() is used.
  WhyServer(const ros::NodeHandle& node, const MissionServer* server);
  ~WhyServer();
  WhyServer(const WhyServer&) = delete;
  WhyServer& operator=(const WhyServer&) = delete;

  PlanArchive& archive() { return archive_; }

 private:
  bool Handle(kg_msgs::Why::Request& request, kg_msgs::Why::Response& response);

  PlanArchive archive_;
  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  const MissionServer* server_;
  ros::ServiceServer service_;
  ros::AsyncSpinner spinner_;
};

}  // namespace kg_ros

#endif  // KG_ROS_KNOWLEDGE_WHY_SERVER_H_
