// A planner's waypoint graph as facts: what it is and what it was made of in
// the provenance graph, written once; its waypoints, edges and edge costs in
// the graph of every run that used it, where most of a run's volume is.
//
//   ex:nav\/<hash>   a ex:NavGraph ; ex:hash ; prov:wasDerivedFrom tensor,
//       seam rules, work field, and the graph before or the start ;
//       prov:wasGeneratedBy ex:compile\/phi1\/12\/alpha
//   ex:nav\/<hash>\/waypoint\/3       a ex:Waypoint ; ex:inGraph ...
//   ex:nav\/<hash>\/edge\/1-3         a ex:TraverseEdge ; ex:from ; ex:to ...
//   ex:nav\/<hash>\/edge\/1-4-0-3   a walk by way of 4 and 0
//   ex:nav\/<hash>\/edge\/within\/2-0   likewise, between its own waypoints
//   ex:nav\/<hash>\/edge\/1-3\/cost   a ex:EdgeCost ; ex:costHours ...

#ifndef KG_ENGINE_FACTS_NAV_GRAPH_FACTS_H_
#define KG_ENGINE_FACTS_NAV_GRAPH_FACTS_H_

#include <cstdint>
#include <string>
#include <vector>

#include "kg_compiler/compile/mission_compiler.h"
#include "kg_compiler/control_plane/edge_cost.h"
#include "kg_compiler/control_plane/nav_graph.h"
#include "kg_core/rdf/store.h"

namespace kg_engine {

kg_core::Term NavGraphNode(const std::string& hash);
// An edge of the graph with this hash: where it begins, its stops, the last
// where it ends.
kg_core::Term EdgeNode(const std::string& graph_hash, int from,
                       const std::vector<int>& stops);
// A waypoint of the graph with this hash.
kg_core::Term WaypointNode(const std::string& graph_hash, unsigned id);
// One that stays within its window.
kg_core::Term InnerEdgeNode(const std::string& graph_hash, unsigned from,
                            unsigned to);

// What is kept of a graph: enough for its provenance.
struct NavGraphStamp {
  std::string hash;
  std::string movement_mode = "hops";
  double made_s = 0.0;  // Unix seconds; 0: not known.
};
NavGraphStamp ToStamp(const kg_compiler::NavGraph& graph, double made_s);

// A graph and what it was made from.
struct NavGraphOrigin {
  std::string agent_iri;
  int window = 0;
  NavGraphStamp stamp;
  std::string previous_hash;  // Of the window before; empty: from the start.
  std::uint64_t cycle = 0;
  double began_s = 0.0;  // When the planner could begin, Unix seconds.
};

// Does it leave from the start, or is the graph before it known?
bool IsJoined(const NavGraphOrigin& origin,
              const kg_compiler::SeamRules& rules);

// Stages the graph's node and the planner's activity, unless they are known.
// Nothing if the compilation does not have the agent and window, or the graph
// before it is not known.
void StageNavGraph(const NavGraphOrigin& origin,
                   const kg_compiler::Compilation& compilation,
                   kg_core::Transaction* transaction);

// Where a graph stands among the facts.
struct NavGraphPlace {
  unsigned long long run = 0;
  std::string previous_hash;  // Of the window before; empty: edges leave from
  std::string start_iri;      // this node.
};

// Waypoints, edges and edge costs of one graph.
std::vector<kg_core::Statement> NavGraphStatements(
    const kg_compiler::NavGraph& graph, const NavGraphPlace& place);

// What it is: class, agent, window, mode, hash.
std::vector<kg_core::Statement> NavGraphDescription(
    const NavGraphOrigin& origin, const kg_mission::Mission& mission);

// One ex:EdgeCost, in `graph`.
std::vector<kg_core::Statement> EdgeCostStatements(
    const kg_core::Term& graph, const kg_core::Term& edge,
    const std::string& agent_iri, const kg_compiler::EdgeCost& cost);

}  // namespace kg_engine

#endif  // KG_ENGINE_FACTS_NAV_GRAPH_FACTS_H_
