#include "kg_engine/what_if/what_if_facts.h"

#include <utility>

#include "kg_base/common/clock.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_engine/facts/nav_graph_facts.h"
#include "kg_engine/facts/plan_facts.h"

namespace kg_engine {
namespace {

using kg_core::Statement;
using kg_selector::TeamMember;

kg_core::Term GraphNamed(const std::string& name) {
  return kg_core::Iri(kg_core::kPlanGraphPrefix + name);
}

void AddAll(std::vector<Statement> statements, const std::string& graph,
            kg_core::Transaction* transaction) {
  const kg_core::Term name = GraphNamed(graph);
  for (Statement& statement : statements) {
    statement.graph = name;
    transaction->Add(statement);
  }
}

PlanRecord RecordOf(const CompiledPlan& world, const HypotheticalRun& run) {
  PlanRecord record;
  record.plan = kg_selector::ToCommittedPlan(world.planned);
  record.plan.run = run.number;
  record.plan.world_version = world.compilation->world_version;
  record.executed = run.executed;
  for (const kg_selector::RejectedPath& rejection :
       world.planned.plan.rejections) {
    const TeamMember* member =
        world.planned.FindMember(rejection.pathlet.agent);
    record.rejections.push_back({member->rules.agent_iri, rejection});
  }
  for (const TeamMember& member : world.planned.members) {
    for (const kg_compiler::NavGraph& graph : member.graphs) {
      record.nav_graphs[{NameOf(member), graph.window}].hash = graph.hash;
    }
  }
  record.started_s = record.ended_s = kg_base::Now_s();
  return record;
}

void RecordGraphs(const CompiledPlan& world, const TeamMember& member,
                  const HypotheticalRun& run,
                  kg_core::Transaction* transaction) {
  NavGraphPlace place;
  place.run = run.number;
  const kg_mission::Mission& mission = world.compilation->mission;
  place.start_iri = member.rules.start_iri;
  for (const kg_compiler::NavGraph& graph : member.graphs) {
    NavGraphOrigin origin;
    origin.agent_iri = member.rules.agent_iri;
    origin.window = graph.window;
    origin.stamp = ToStamp(graph, 0.0);
    AddAll(NavGraphDescription(origin, mission), run.graph, transaction);
    AddAll(NavGraphStatements(graph, place), run.graph, transaction);
    place.previous_hash = graph.hash;
  }
}

}  // namespace

void RecordCompiledPlan(const CompiledPlan& world, const HypotheticalRun& run,
                        kg_core::Transaction* transaction) {
  AddAll(PlanStatements(RecordOf(world, run), *world.compilation), run.graph,
         transaction);
  for (const TeamMember& member : world.planned.members) {
    RecordGraphs(world, member, run, transaction);
  }
}

void RecordPrices(const kg_selector::PlannedMission& now,
                  const EdgePrices& prices, const std::string& graph,
                  kg_core::Transaction* transaction) {
  for (std::size_t i = 0; i < now.members.size(); ++i) {
    const TeamMember& member = now.members[i];
    for (std::size_t w = 0; w < member.graphs.size(); ++w) {
      const kg_compiler::NavGraph& edges = member.graphs[w];
      for (std::size_t e = 0; e < edges.edges.size(); ++e) {
        const kg_compiler::TraverseEdge* then = prices.Then(i, w, e);
        if (then == nullptr) continue;
        AddAll(
            EdgeCostStatements(GraphNamed(graph),
                               EdgeNode(edges.hash, edges.edges[e].from,
                                        kg_compiler::StopsOf(edges.edges[e])),
                               edges.agent_iri, kg_compiler::CostOfEdge(*then)),
            graph, transaction);
      }
    }
  }
}

}  // namespace kg_engine
