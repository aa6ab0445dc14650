// MissionServer's plans: recorded with their provenance, superseded, dropped.

#include <algorithm>
#include <utility>

#include "kg_core/facts/terms.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_ros/conversion/message_units.h"
#include "kg_ros/knowledge/fact_writer.h"
#include "kg_ros/knowledge/mission_server.h"

namespace kg_ros {
namespace {

using kg_core::Iri;
using kg_core::Literal;
using kg_core::Term;
using kg_core::Transaction;
using kg_core::WorldChange;

constexpr std::uint64_t kKeptPlans = 5;

PlannedPlaces PlacesOf(const kg_msgs::Assignments& plan) {
  PlannedPlaces places;
  for (const kg_msgs::Assignment& assignment : plan.assignments) {
    for (const kg_msgs::Visit& visit : assignment.pathlet.visits) {
      places[{assignment.agent, visit.window}] = GetPosition(visit);
    }
  }
  return places;
}

}  // namespace

void MissionServer::RecordPlan(PlanRecord record) {
  record.executed = start_.executed;
  const std::uint64_t run = record.assignments.plan_run;
  Transaction transaction = store_->Begin();
  for (const auto& [key, stamp] : record.nav_graphs) {
    NavGraphOrigin origin;
    origin.agent_iri = AgentIri(key.first);
    origin.window = key.second;
    origin.stamp = stamp;
    if (!(stamp.made_s > 0.0)) origin.stamp.made_s = record.ended_s;
    const auto previous = record.nav_graphs.find({key.first, key.second - 1});
    if (previous != record.nav_graphs.end()) {
      origin.previous_hash = previous->second.hash;
    }
    StageGraph(origin, &transaction);
  }
  AddAll(PlanStatements(record, *compilation_), &transaction);
  if (plan_run_ > 0 && plan_run_ != run) {
    StagePlanStatus(plan_run_, "superseded", &transaction);
  }
  DropOldPlans(run, &transaction);
  StageSave(run, &transaction);
  transaction.Commit(WorldChange::kNo);
  plan_run_ = run;
  const std::lock_guard<std::mutex> lock(mutex_);
  start_.in_force = {run, PlacesOf(record.assignments)};
}

std::string MissionServer::AgentIri(const std::string& agent_id) const {
  for (const kg_core::Agent& agent : compilation_->mission.agents) {
    if (agent.id == agent_id) return agent.iri;
  }
  return "";
}

void MissionServer::StageGraph(NavGraphOrigin origin,
                               Transaction* transaction) const {
  origin.cycle = cycle_;
  origin.began_s = times_.ended_s;
  StageNavGraph(origin, *compilation_, transaction);
}

void MissionServer::DropOldPlans(const std::uint64_t run,
                                 Transaction* transaction) {
  if (run <= kKeptPlans) return;
  transaction->RemoveMatching(nullptr, nullptr, nullptr,
                              PlanGraph(run - kKeptPlans));
}

void MissionServer::RecordNavGraph(const kg_msgs::NavGraph& graph,
                                   const std::string& previous_hash) {
  const kg_compiler::SeamRules* rules =
      FindRules(*compilation_, graph.agent_iri);
  if (rules == nullptr) return;
  NavGraphPlace place;
  place.run = plan_run_;
  place.previous_hash = previous_hash;
  place.start_iri = rules->start_iri;
  NavGraphOrigin origin;
  origin.agent_iri = graph.agent_iri;
  origin.window = graph.window;
  origin.stamp = StampOf(graph);
  origin.previous_hash = previous_hash;
  if (!IsJoined(origin, *rules)) return;
  Transaction transaction = store_->Begin();
  StageGraph(origin, &transaction);
  AddAll(NavGraphStatements(graph, place), &transaction);
  StageUse(graph, &transaction);
  transaction.Commit(WorldChange::kNo);
}

// A graph that came after its plan: the run used it all the same.
void MissionServer::StageUse(const kg_msgs::NavGraph& graph,
                             Transaction* transaction) const {
  const Term node = NavGraphNode(graph.hash);
  for (const Term& activity :
       {PlanRunNode(plan_run_), SelectRunNode(plan_run_)}) {
    transaction->Add(
        {activity, kg_core::Prov("used"), node, Iri(kg_core::kProvGraph)});
  }
  const Term stop = AssignmentNode(plan_run_, graph.agent, graph.window);
  const Term plan = PlanGraph(plan_run_);
  if (kg_core::Has(transaction->view(), plan.text, stop, kg_core::Ex("status"),
                   Literal("planned"))) {
    transaction->Add({stop, kg_core::Prov("wasDerivedFrom"), node, plan});
  }
}

void MissionServer::RecordEnd() {
  const Term planned = Literal("planned");
  const Term status = Iri(std::string(kg_core::kEx) + "status");
  const Term graph = PlanGraph(plan_run_);
  Transaction transaction = store_->Begin();
  for (const Term& stop :
       kg_core::Subjects(*store_->Read(), graph.text, status, planned)) {
    transaction.Remove({stop, status, planned, graph});
    transaction.Add({stop, status, Literal("executed"), graph});
  }
  StageSave(plan_run_, &transaction);
  transaction.Commit(WorldChange::kNo);
}

void MissionServer::AddExecuted(ExecutedVisit visit) {
  const auto same = [&visit](const ExecutedVisit& known) {
    return known.agent == visit.agent &&
           known.visit.window == visit.visit.window;
  };
  if (std::any_of(executed().begin(), executed().end(), same)) return;
  if (plan_run_ > 0) RecallPlan(*store_->Read(), plan_run_, &visit);
  const std::lock_guard<std::mutex> lock(mutex_);
  start_.executed.push_back(std::move(visit));
}

}  // namespace kg_ros
