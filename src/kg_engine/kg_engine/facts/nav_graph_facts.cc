#include "kg_engine/facts/nav_graph_facts.h"

#include "kg_base/common/join_strings.h"
#include "kg_base/common/units.h"
#include "kg_core/facts/terms.h"
#include "kg_engine/facts/artifact_facts.h"
#include "kg_engine/facts/fact_writer.h"
#include "kg_engine/terms/artifact_names.h"
#include "kg_engine/terms/plan_names.h"

namespace kg_engine {
namespace {

using kg_compiler::EdgeCost;
using kg_compiler::TraverseEdge;
using kg_core::Ex;
using kg_core::GeoTerm;
using kg_core::Iri;
using kg_core::Term;

Term WaypointOf(const Term& graph, unsigned id) {
  return Iri(graph.text + "/waypoint/" + std::to_string(id));
}

Term FieldNode(const kg_compiler::Compilation& compilation, int window) {
  for (const auto& field : compilation.fields) {
    if (field->window == window) return Iri(field->iri);
  }
  return {};
}

// Sources of a graph; empty if the compilation lacks the agent or window.
std::vector<Term> SourcesOf(const NavGraphOrigin& origin,
                            const kg_compiler::Compilation& compilation) {
  const kg_compiler::MissionTensor* tensor =
      FindTensor(compilation, origin.agent_iri, origin.window);
  const kg_compiler::SeamRules* rules =
      FindRules(compilation, origin.agent_iri);
  const Term field = FieldNode(compilation, origin.window);
  if (tensor == nullptr || rules == nullptr || field.text.empty()) return {};
  if (!IsJoined(origin, *rules)) return {};
  const Term before = origin.previous_hash.empty()
                          ? Iri(rules->start_iri)
                          : NavGraphNode(origin.previous_hash);
  return {TensorNode(*tensor, compilation.mission), SeamRulesNode(*rules),
          field, before};
}

void Describe(const NavGraphOrigin& origin, const kg_mission::Mission& mission,
              FactWriter* write) {
  write->About(NavGraphNode(origin.stamp.hash), "NavGraph")
      .Link("forAgent", Iri(origin.agent_iri))
      .Link("forWindow", WindowTerm(mission, origin.window))
      .Text("movementMode", origin.stamp.movement_mode)
      .Text("hash", origin.stamp.hash);
}

// Source node of an edge into the window.
Term EdgeBegin(const TraverseEdge& edge, const NavGraphPlace& place) {
  if (place.previous_hash.empty()) return Iri(place.start_iri);
  return WaypointOf(NavGraphNode(place.previous_hash), edge.from);
}

void WriteStops(const TraverseEdge& edge, const Term& graph,
                FactWriter* write) {
  for (const int stop : edge.via) write->Link("via", WaypointOf(graph, stop));
  if (edge.via.empty()) return;
  write->Text("stopOrder",
              kg_base::JoinStrings(edge.via, " ", [](const int stop) {
                return std::to_string(stop);
              }));
}

void WriteEdgeCost(const Term& edge, const std::string& agent_iri,
                   const EdgeCost& cost, FactWriter* write) {
  write->About(Iri(edge.text + "/cost"), "EdgeCost")
      .Link("forEdge", edge)
      .Link("forAgent", Iri(agent_iri))
      .Cost(cost);
}

// Writes an edge of the graph and its cost.
void WriteEdge(const TraverseEdge& edge, const Term& edge_node,
               const Term& from, const kg_compiler::NavGraph& graph,
               FactWriter* write) {
  const Term node = NavGraphNode(graph.hash);
  write->About(edge_node, "TraverseEdge")
      .Link("inGraph", node)
      .Link("from", from)
      .Link("to", WaypointOf(node, edge.to));
  WriteStops(edge, node, write);
  WriteEdgeCost(edge_node, graph.agent_iri, kg_compiler::CostOfEdge(edge),
                write);
}

}  // namespace

Term WaypointNode(const std::string& graph_hash, unsigned id) {
  return WaypointOf(NavGraphNode(graph_hash), id);
}

Term InnerEdgeNode(const std::string& graph_hash, unsigned from, unsigned to) {
  return Iri(NavGraphNode(graph_hash).text + "/edge/within/" +
             std::to_string(from) + "-" + std::to_string(to));
}

Term EdgeNode(const std::string& graph_hash, int from,
              const std::vector<int>& stops) {
  std::string name = std::to_string(from);
  for (const int stop : stops) name += "-" + std::to_string(stop);
  return Iri(NavGraphNode(graph_hash).text + "/edge/" + name);
}

std::vector<kg_core::Statement> EdgeCostStatements(const Term& graph,
                                                   const Term& edge,
                                                   const std::string& agent_iri,
                                                   const EdgeCost& cost) {
  FactWriter write(graph);
  WriteEdgeCost(edge, agent_iri, cost, &write);
  return write.Take();
}

std::vector<kg_core::Statement> NavGraphDescription(
    const NavGraphOrigin& origin, const kg_mission::Mission& mission) {
  FactWriter write(Iri(kg_core::kProvGraph));
  Describe(origin, mission, &write);
  return write.Take();
}

Term NavGraphNode(const std::string& hash) { return Ex("nav/" + hash); }

NavGraphStamp ToStamp(const kg_compiler::NavGraph& graph, const double made_s) {
  return {graph.hash, kg_compiler::Name(graph.movement_mode), made_s};
}

bool IsJoined(const NavGraphOrigin& origin,
              const kg_compiler::SeamRules& rules) {
  return !origin.previous_hash.empty() ||
         (!rules.windows.empty() &&
          rules.windows.front().window == origin.window);
}

void StageNavGraph(const NavGraphOrigin& origin,
                   const kg_compiler::Compilation& compilation,
                   kg_core::Transaction* transaction) {
  const Term node = NavGraphNode(origin.stamp.hash);
  const kg_compiler::SeamRules* rules =
      FindRules(compilation, origin.agent_iri);
  const std::vector<Term> sources = SourcesOf(origin, compilation);
  if (sources.empty() || IsDescribed(transaction->view(), node)) return;
  const Term activity =
      Iri(CompileNode("phi1", origin.cycle).text + "/" + rules->agent_id);
  FactWriter write(Iri(kg_core::kProvGraph));
  Describe(origin, compilation.mission, &write);
  write.GeneratedBy(activity);
  for (const Term& source : sources) write.DerivedFrom(source);
  if (!IsDescribed(transaction->view(), activity)) {
    write.Activity(activity, "CompilePhi1", origin.began_s, origin.stamp.made_s)
        .Integer("worldVersion",
                 static_cast<long long>(compilation.world_version));
  }
  write.About(activity);
  for (const Term& source : sources) write.Used(source);
  AddAll(write.Take(), transaction);
}

std::vector<kg_core::Statement> NavGraphStatements(
    const kg_compiler::NavGraph& graph, const NavGraphPlace& place) {
  FactWriter write(PlanGraph(place.run));
  const Term node = NavGraphNode(graph.hash);
  for (const kg_compiler::Waypoint& waypoint : graph.waypoints) {
    write.About(WaypointOf(node, waypoint.id), "Waypoint")
        .Link("inGraph", node)
        .Number("score", waypoint.score)
        .Position(GeoTerm("asWKT"), waypoint.position);
  }
  for (const TraverseEdge& edge : graph.edges) {
    WriteEdge(edge, EdgeNode(graph.hash, edge.from, kg_compiler::StopsOf(edge)),
              EdgeBegin(edge, place), graph, &write);
  }
  for (const TraverseEdge& edge : graph.inner_edges) {
    WriteEdge(edge, InnerEdgeNode(graph.hash, edge.from, edge.to),
              WaypointOf(node, edge.from), graph, &write);
  }
  return write.Take();
}

}  // namespace kg_engine
