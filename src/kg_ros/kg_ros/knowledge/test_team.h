// For tests: everybody's planners and the selector beside a MissionServer, in
// one process and without topics. Plan() does what a cycle of the nodes does.

#ifndef KG_ROS_KNOWLEDGE_TEST_TEAM_H_
#define KG_ROS_KNOWLEDGE_TEST_TEAM_H_

#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "kg_core/base/temporary_folder.h"
#include "kg_ros/conversion/rules_conversion.h"
#include "kg_ros/conversion/tensor_conversion.h"
#include "kg_ros/knowledge/mission_server.h"
#include "kg_ros/knowledge/plan_progress.h"
#include "kg_ros/knowledge/test_mission.h"
#include "kg_ros/planning/planner_server.h"
#include "kg_ros/selection/selector_server.h"
#include "ros/time.h"

namespace kg_ros {

// A second agent beside the test mission's: so near that the two are in each
// other's way.
inline constexpr char kSecondAgent[] = R"ttl(
ex:mission ex:hasAgent ex:bravo .
ex:bravo a ex:Agent ; ex:id "bravo" ; ex:mobility "glider" ;
    ex:usesPolicy ex:fast ; ex:hasCapabilities ex:alpha_capabilities .
ex:bravo_start a ex:AgentState ; ex:forAgent ex:bravo ; ex:forWindow ex:w0 ;
    geo:asWKT "POINT(-90.85 25.72)"^^geo:wktLiteral ; ex:headingDeg 0 .
)ttl";

// A server of the test mission, which is written into `folder`.
inline std::unique_ptr<MissionServer> StartTestServer(
    const kg_core::TemporaryFolder& folder) {
  ros::Time::init();
  MissionFolders folders;
  folders.mission = folder / "mission";
  folders.state = folder / "state";
  folders.ontology = "../kg_core/ontology";
  WriteTestMission(folders.mission);
  return std::make_unique<MissionServer>(folders);
}

class TestTeam {
 public:
  explicit TestTeam(MissionServer* server) : server_(server) {}

  // One cycle; the plan is recorded with its graphs. Throws std::runtime_error
  // if there is none.
  const kg_msgs::Assignments& Plan() {
    compilation_ = server_->BeginCycle();
    progress_.Begin(server_->cycle());
    selector_.KnowRun(server_->plan_run());
    Follow(selector_.Take(
        ToMessage(CoordinationOf(*compilation_, server_->cycle()))));
    for (const auto& rules : compilation_->rules) Ask(rules);
    const auto plan = progress_.TakeFinishedPlan();
    if (!plan) throw std::runtime_error("no plan was made");
    plan_ = *plan;
    Record();
    return plan_;
  }

  const kg_compiler::Compilation& compilation() const { return *compilation_; }

  const PlanProgress& progress() const { return progress_; }

  // The stops of a window are made.
  void Pass(int window) {
    for (const kg_msgs::Assignment& assignment : plan_.assignments) {
      for (const kg_msgs::Visit& visit : assignment.pathlet.visits) {
        if (visit.window != window) continue;
        server_->AddExecuted({assignment.agent, assignment.agent_iri, visit});
      }
    }
  }

 private:
  void Ask(const kg_compiler::SeamRules& rules) {
    using kg_compiler::Layer;
    PlannerServer& planner = planners_[rules.agent_id];
    const auto version = compilation_->world_version;
    for (const auto& field : compilation_->fields) {
      planner.Take(ToMessage(*field, version));
    }
    for (const auto& tensor : compilation_->tensors) {
      if (tensor->agent_iri != rules.agent_iri) continue;
      planner.Take(
          ToMessage(*tensor, rules.agent_id, version,
                    {Layer::kFused, Layer::kFeasibility, Layer::kAttenuation}));
    }
    planner.Take(ToMessage(rules, server_->cycle()));
    Give(planner.Plan());
  }

  void Give(const PlannerAnswer& answer) {
    for (const kg_msgs::NavGraph& graph : answer.nav_graphs) {
      progress_.Take(graph);
    }
    Follow(selector_.Take(answer.candidates));
  }

  void Follow(const SelectorAnswer& answer) {
    if (answer.assignments) progress_.Take(*answer.assignments);
    if (!answer.rejections) return;
    progress_.Take(*answer.rejections);
    for (auto& [agent, planner] : planners_) {
      const auto again = planner.PlanAgain(*answer.rejections);
      if (again) Give(*again);
    }
  }

  void Record() {
    PlanRecord record;
    record.assignments = plan_;
    record.rejections = progress_.rejections();
    record.cooling = progress_.cooling();
    record.prices = progress_.prices();
    for (const auto& [key, graph] : progress_.nav_graphs()) {
      record.nav_graphs[key] = StampOf(graph);
    }
    record.started_s = ros::WallTime::now().toSec();
    record.ended_s = record.started_s;
    server_->RecordPlan(record);
    while (const kg_msgs::NavGraph* graph = progress_.NextUnrecorded()) {
      const auto before =
          progress_.nav_graphs().find({graph->agent, graph->window - 1});
      server_->RecordNavGraph(*graph, before == progress_.nav_graphs().end()
                                          ? ""
                                          : before->second.hash);
    }
  }

  MissionServer* server_;
  std::map<std::string, PlannerServer> planners_;
  SelectorServer selector_;
  PlanProgress progress_;
  std::shared_ptr<const kg_compiler::Compilation> compilation_;
  kg_msgs::Assignments plan_;
};

}  // namespace kg_ros

#endif  // KG_ROS_KNOWLEDGE_TEST_TEAM_H_
