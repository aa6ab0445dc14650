// Plans a mission in one process: a MissionServer with a planner for every
// agent and the team's selector, without messages. One cycle equals what
// kg_node, the planner nodes and the selector node do together.
//
//   MissionServer server(folders);
//   MissionPlanning planning(&server);
//   const kg_selector::CommittedPlan& plan = planning.Plan();

#ifndef KG_ENGINE_SERVER_MISSION_PLANNING_H_
#define KG_ENGINE_SERVER_MISSION_PLANNING_H_

#include <map>
#include <memory>
#include <string>

#include "kg_compiler/compile/mission_compiler.h"
#include "kg_engine/planning/agent_planner.h"
#include "kg_engine/planning/team_selector.h"
#include "kg_engine/server/mission_server.h"
#include "kg_engine/server/plan_progress.h"
#include "kg_selector/team/committed_plan.h"

namespace kg_engine {

class MissionPlanning {
 public:
  // `server` must outlive this object.
  explicit MissionPlanning(MissionServer* server) : server_(server) {}

  // Runs one cycle from the agents' current positions; the plan is recorded
  // with its graphs. Throws kg_base::InputError if the facts cannot be
  // compiled.
  const kg_selector::CommittedPlan& Plan();

  // Results of the last cycle.
  const kg_compiler::Compilation& compilation() const { return *compilation_; }
  const PlanProgress& progress() const { return progress_; }

  // Marks the last plan's stops in a window as executed.
  void PassWindow(int window);

 private:
  void AskPlanner(const kg_compiler::SeamRules& rules);
  void Give(const PlannerAnswer& answer);
  void Follow(const SelectorAnswer& answer);
  void Record(double began_s);

  MissionServer* server_;
  std::map<std::string, AgentPlanner> planners_;  // By ex:id.
  TeamSelector selector_;
  PlanProgress progress_;
  std::shared_ptr<const kg_compiler::Compilation> compilation_;
  kg_selector::CommittedPlan plan_;
};

}  // namespace kg_engine

#endif  // KG_ENGINE_SERVER_MISSION_PLANNING_H_
