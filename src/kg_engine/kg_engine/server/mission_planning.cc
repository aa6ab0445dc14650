#include "kg_engine/server/mission_planning.h"

#include <optional>
#include <stdexcept>

#include "kg_base/common/clock.h"

namespace kg_engine {

using kg_selector::CommittedPlan;

const CommittedPlan& MissionPlanning::Plan() {
  const double began_s = kg_base::Now_s();
  compilation_ = server_->BeginCycle();
  progress_.Begin(server_->cycle());
  selector_.KnowRun(server_->plan_run());
  Follow(selector_.Take(ToTeamTask(*compilation_, server_->cycle())));
  // The selector commits as soon as the last planner has answered.
  for (const auto& rules : compilation_->rules) AskPlanner(rules);
  const std::optional<CommittedPlan> plan = progress_.TakeFinishedPlan();
  if (!plan) throw std::logic_error("the selector waits though all answered");
  plan_ = *plan;
  Record(began_s);
  return plan_;
}

void MissionPlanning::AskPlanner(const kg_compiler::SeamRules& rules) {
  AgentPlanner& planner = planners_[rules.agent_id];
  for (const auto& field : compilation_->fields) planner.Take(field);
  for (const auto& tensor : compilation_->tensors) {
    if (tensor->agent_iri == rules.agent_iri) planner.Take(tensor);
  }
  planner.Take(rules, server_->cycle());
  Give(planner.Plan());
}

void MissionPlanning::Give(const PlannerAnswer& answer) {
  for (const AgentGraph& graph : answer.graphs) progress_.Take(graph);
  Follow(selector_.Take(answer.candidates));
}

void MissionPlanning::Follow(const SelectorAnswer& answer) {
  if (answer.plan) progress_.Take(*answer.plan);
  if (answer.end) progress_.Take(*answer.end);
  if (!answer.request) return;
  progress_.Take(*answer.request);
  // Planners of agents no longer in the mission do not answer.
  for (auto& [agent, planner] : planners_) {
    const auto again = planner.PlanAgain(*answer.request);
    if (again) Give(*again);
  }
}

void MissionPlanning::Record(const double began_s) {
  PlanRecord record = progress_.MakeRecord(plan_);
  record.started_s = began_s;
  record.ended_s = kg_base::Now_s();
  server_->RecordPlan(record);
  while (const AgentGraph* graph = progress_.NextUnrecorded()) {
    server_->RecordGraph(*graph, progress_.HashBefore(*graph));
  }
}

void MissionPlanning::PassWindow(const int window) {
  for (const kg_selector::PathAssignment& assignment : plan_.assignments) {
    for (const kg_selector::Visit& visit : assignment.pathlet.visits) {
      if (visit.window != window) continue;
      server_->AddExecuted(
          {assignment.pathlet.agent, assignment.agent_iri, visit});
    }
  }
}

}  // namespace kg_engine
