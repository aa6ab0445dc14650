// The ROS interface of kg_node: converts messages, calls the MissionServer,
// publishes. Topics and services: docs/interface.md.

#ifndef KG_ROS_KNOWLEDGE_KG_NODE_H_
#define KG_ROS_KNOWLEDGE_KG_NODE_H_

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "diagnostic_updater/diagnostic_updater.h"
#include "kg_engine/http/sparql_http_server.h"
#include "kg_engine/server/mission_server.h"
#include "kg_engine/server/plan_progress.h"
#include "kg_mission/mission/data_quality.h"
#include "kg_msgs/AgentState.h"
#include "kg_msgs/Assignments.h"
#include "kg_msgs/Candidates.h"
#include "kg_msgs/FactUpdate.h"
#include "kg_msgs/NavGraph.h"
#include "kg_msgs/Rejections.h"
#include "kg_msgs/RoundRequest.h"
#include "kg_msgs/UpdateFacts.h"
#include "kg_msgs/UpdateReport.h"
#include "kg_msgs/Validate.h"
#include "kg_msgs/World.h"
#include "kg_ros/base/main_thread.h"
#include "kg_ros/display/rviz_publisher.h"
#include "kg_ros/knowledge/artifact_publisher.h"
#include "kg_ros/knowledge/check_server.h"
#include "kg_ros/knowledge/pending_reports.h"
#include "kg_ros/knowledge/plan_status.h"
#include "kg_ros/knowledge/query_server.h"
#include "kg_ros/knowledge/watch_server.h"
#include "kg_ros/knowledge/what_if_server.h"
#include "kg_ros/knowledge/why_server.h"
#include "ros/node_handle.h"
#include "ros/timer.h"

namespace kg_ros {

class KgNode {
 public:
  // Opens the mission; throws kg_base::InputError.
  KgNode(const kg_engine::MissionFolders& folders,
         const kg_engine::SparqlHttpOptions& http, const ros::NodeHandle& node,
         const ros::NodeHandle& own);
  ~KgNode();

  // Runs until ROS shuts down. Pending messages are processed first; then the
  // dirty artifacts are compiled once.
  void Spin();

 private:
  void Subscribe();
  void ExpectFirstPlan();
  void HandleFacts(const kg_msgs::FactUpdate& message);
  bool HandleUpdate(kg_msgs::UpdateFacts::Request& request,
                    kg_msgs::UpdateFacts::Response& response);
  bool HandleValidate(kg_msgs::Validate::Request& request,
                      kg_msgs::Validate::Response& response);
  void HandleAgentState(const kg_msgs::AgentState& message);
  void HandleNavGraph(const kg_msgs::NavGraph& message);
  void HandleCandidates(const kg_msgs::Candidates& message);
  void HandleAssignments(const kg_msgs::Assignments& message);
  void HandleRoundRequest(const kg_msgs::RoundRequest& message);
  void HandleRejections(const kg_msgs::Rejections& message);

  kg_msgs::UpdateReport Decide(const kg_core::FactUpdate& update);
  void StartHttpServer(const kg_engine::SparqlHttpOptions& options);
  // From any thread but the main one, where it is decided.
  kg_engine::UpdateVerdict DecideForHttp(const kg_core::FactUpdate& update);
  kg_msgs::UpdateReport Report(const kg_core::FactUpdate& update,
                               const kg_engine::Decision& decision,
                               std::uint64_t before);
  // Retracts facts that have expired in mission time.
  void ExpireFacts();
  // Reports times that no window covers, when they have changed.
  void TellGaps(kg_msgs::UpdateReport* report);
  // Reports facts without effect, when they have changed.
  void TellWarnings();
  void StartCycle();
  bool FleetIsReady() const;
  void FailCycle(const std::string& why);
  void CommitFinishedPlan();
  void ReportPlan(const kg_selector::CommittedPlan& plan, double commit_s);
  // Runs `work`; logs invalid messages (InputError).
  static void Guarded(const std::function<void()>& work);
  // Records the facts of one waypoint graph of the plan while the node is idle.
  void RecordNextGraph();
  void PassWindows(int from, int to);
  // Periodic (2 Hz) check for missing nodes and the window in view.
  void Watch();
  std::string MissingNodes() const;
  int ViewWindow() const;
  void PublishWorld();
  void Diagnose(diagnostic_updater::DiagnosticStatusWrapper& status);
  void DiagnoseData(diagnostic_updater::DiagnosticStatusWrapper& status);

  ros::NodeHandle node_;
  ros::NodeHandle own_;
  double opening_s_;  // Begin of opening the server [Unix s].
  kg_engine::MissionServer server_;
  ArtifactPublisher artifacts_;
  RvizPublisher rviz_;
  QueryServer queries_;
  WhatIfServer what_ifs_;
  CheckServer checks_;
  WatchServer watches_;
  WhyServer why_;
  kg_engine::PlanProgress progress_;
  diagnostic_updater::Updater diagnostics_;

  std::vector<ros::Subscriber> subscribers_;
  std::vector<ros::ServiceServer> services_;
  ros::Publisher updates_;
  ros::Publisher world_;
  ros::WallTimer watch_;

  std::shared_ptr<const kg_compiler::Compilation> compilation_;
  std::optional<kg_selector::CommittedPlan> plan_;  // Last committed plan.
  PendingReports pending_;
  std::vector<std::string> gaps_;  // Gaps last reported.
  std::vector<std::string>
      warnings_;  // FindWarnings and DataWarnings, reported.
  std::vector<kg_mission::DataSummary> data_;  // Of this cycle.
  bool cycle_is_due_ = true;
  // End of the wait for poses at a new window [Unix s].
  double patience_ends_s_ = 0.0;
  bool fleet_has_moved_ = false;
  bool graphs_are_new_ = false;
  int moves_ = 0;  // Watch() calls that found the fleet moved.
  int shown_window_ = -1;
  double cycle_began_s_ = 0.0;  // Unix seconds.
  PlanStatus plan_status_;

  MainThread main_thread_;
  std::optional<kg_engine::SparqlHttpServer>
      http_;  // Ends first: its threads use the others.
};

}  // namespace kg_ros

#endif  // KG_ROS_KNOWLEDGE_KG_NODE_H_
