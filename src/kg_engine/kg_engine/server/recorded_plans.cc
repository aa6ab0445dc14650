#include "kg_engine/server/recorded_plans.h"

#include <utility>

#include "kg_core/facts/terms.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_engine/facts/fact_writer.h"
#include "kg_engine/facts/nav_graph_facts.h"
#include "kg_engine/facts/plan_status.h"
#include "kg_engine/terms/artifact_names.h"
#include "kg_engine/terms/plan_names.h"

namespace kg_engine {
namespace {

using kg_core::Iri;
using kg_core::Literal;
using kg_core::Term;
using kg_core::Transaction;

constexpr std::uint64_t kKeptPlans = 5;

std::string FindAgentIri(const kg_compiler::Compilation& compilation,
                         const std::string& agent_id) {
  for (const kg_mission::Agent& agent : compilation.mission.agents) {
    if (agent.id == agent_id) return agent.iri;
  }
  return "";
}

void StageOrigin(NavGraphOrigin origin, const RecordedCycle& cycle,
                 Transaction* transaction) {
  origin.cycle = cycle.number;
  origin.began_s = cycle.compiled_s;
  StageNavGraph(origin, cycle.compilation, transaction);
}

// Stages the provenance of every graph used by the plan.
void StageGraphsOf(const PlanRecord& record, const RecordedCycle& cycle,
                   Transaction* transaction) {
  for (const auto& [key, stamp] : record.nav_graphs) {
    NavGraphOrigin origin;
    origin.agent_iri = FindAgentIri(cycle.compilation, key.first);
    origin.window = key.second;
    origin.stamp = stamp;
    if (!(stamp.made_s > 0.0)) origin.stamp.made_s = record.ended_s;
    const auto previous = record.nav_graphs.find({key.first, key.second - 1});
    if (previous != record.nav_graphs.end()) {
      origin.previous_hash = previous->second.hash;
    }
    StageOrigin(origin, cycle, transaction);
  }
}

void DropOldPlan(const std::uint64_t run, Transaction* transaction) {
  if (run <= kKeptPlans) return;
  transaction->RemoveMatching(nullptr, nullptr, nullptr,
                              PlanGraph(run - kKeptPlans));
}

}  // namespace

void RecordedPlans::StagePlan(const PlanRecord& record,
                              const RecordedCycle& cycle,
                              Transaction* transaction) const {
  const std::uint64_t run = record.plan.run;
  StageGraphsOf(record, cycle, transaction);
  AddAll(PlanStatements(record, cycle.compilation), transaction);
  if (run_ > 0 && run_ != run) {
    StagePlanStatus(run_, "superseded", transaction);
  }
  DropOldPlan(run, transaction);
}

bool RecordedPlans::StageGraph(const AgentGraph& graph,
                               const std::string& previous_hash,
                               const RecordedCycle& cycle,
                               Transaction* transaction) const {
  const kg_compiler::NavGraph& made = *graph.graph;
  const kg_compiler::SeamRules* rules =
      FindRules(cycle.compilation, made.agent_iri);
  if (rules == nullptr) return false;
  NavGraphPlace place;
  place.run = run_;
  place.previous_hash = previous_hash;
  place.start_iri = rules->start_iri;
  NavGraphOrigin origin;
  origin.agent_iri = made.agent_iri;
  origin.window = made.window;
  origin.stamp = ToStamp(made, graph.made_s);
  origin.previous_hash = previous_hash;
  if (!IsJoined(origin, *rules)) return false;
  StageOrigin(origin, cycle, transaction);
  AddAll(NavGraphStatements(made, place), transaction);
  StageUse(graph, transaction);
  return true;
}

// Records the use of a graph that arrived after its plan.
void RecordedPlans::StageUse(const AgentGraph& graph,
                             Transaction* transaction) const {
  const Term node = NavGraphNode(graph.graph->hash);
  for (const Term& activity : {PlanRunNode(run_), SelectRunNode(run_)}) {
    transaction->Add(
        {activity, kg_core::Prov("used"), node, Iri(kg_core::kProvGraph)});
  }
  const Term stop = AssignmentNode(run_, graph.agent, graph.window());
  const Term plan = PlanGraph(run_);
  if (kg_core::Has(transaction->view(), plan.text, stop, kg_core::Ex("status"),
                   Literal("planned"))) {
    transaction->Add({stop, kg_core::Prov("wasDerivedFrom"), node, plan});
  }
}

void RecordedPlans::StageStale(Transaction* transaction) const {
  if (run_ > 0) StagePlanStatus(run_, "stale", transaction);
}

void RecordedPlans::StageEnd(const kg_core::GraphView& view,
                             Transaction* transaction) const {
  const Term planned = Literal("planned");
  const Term status = Iri(std::string(kg_core::kEx) + "status");
  const Term graph = PlanGraph(run_);
  for (const Term& stop :
       kg_core::Subjects(view, graph.text, status, planned)) {
    transaction->Remove({stop, status, planned, graph});
    transaction->Add({stop, status, Literal("executed"), graph});
  }
}

PlannedPlaces ToPlannedPlaces(const kg_selector::CommittedPlan& plan) {
  PlannedPlaces places;
  for (const kg_selector::PathAssignment& assignment : plan.assignments) {
    for (const kg_selector::Visit& visit : assignment.pathlet.visits) {
      places[{assignment.pathlet.agent, visit.window}] = visit.position;
    }
  }
  return places;
}

}  // namespace kg_engine
