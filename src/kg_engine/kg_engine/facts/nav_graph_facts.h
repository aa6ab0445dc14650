// A planner's waypoint graph as facts: its description and inputs in the
// provenance graph, written once; its waypoints, edges and edge costs, the bulk
// of the data, in the graph of every run that used it.
//
//   ex:nav\/<hash>   a ex:NavGraph ; ex:hash ; prov:wasDerivedFrom tensor,
//       seam rules, work field, and the graph before or the start ;
//       prov:wasGeneratedBy ex:compile\/phi1\/12\/alpha
//   ex:nav\/<hash>\/waypoint\/3       a ex:Waypoint ; ex:inGraph ...
//   ex:nav\/<hash>\/edge\/1-3         a ex:TraverseEdge ; ex:from ; ex:to ...
//   ex:nav\/<hash>\/edge\/1-4-0-3   a walk via 4 and 0
//   ex:nav\/<hash>\/edge\/within\/2-0   edge between two waypoints of the
//   window ex:nav\/<hash>\/edge\/1-3\/cost   a ex:EdgeCost ; ex:costHours ...

#ifndef KG_ENGINE_FACTS_NAV_GRAPH_FACTS_H_
#define KG_ENGINE_FACTS_NAV_GRAPH_FACTS_H_

#include <cstdint>
#include <string>
#include <vector>

#include "kg_compiler/compile/mission_compiler.h"
#include "kg_compiler/control_plane/edge_cost.h"
#include "kg_compiler/control_plane/nav_graph.h"
#include "kg_core/rdf/store.h"
#include "kg_mission/mission/option_names.h"

namespace kg_engine {

kg_core::Term NavGraphNode(const std::string& hash);
// An edge of the graph with this hash: its source, then its stops, the last of
// which is its end.
kg_core::Term EdgeNode(const std::string& graph_hash, int from,
                       const std::vector<int>& stops);
// A waypoint of the graph with this hash.
kg_core::Term WaypointNode(const std::string& graph_hash, unsigned id);
// An edge within its window.
kg_core::Term InnerEdgeNode(const std::string& graph_hash, unsigned from,
                            unsigned to);

// Data kept of a graph for its provenance.
struct NavGraphStamp {
  std::string hash;
  std::string movement_mode = kg_mission::kHopsMovement;
  double made_s = 0.0;  // Unix seconds; 0 = unknown.
};
NavGraphStamp ToStamp(const kg_compiler::NavGraph& graph, double made_s);

// A graph and what it was made from.
struct NavGraphOrigin {
  std::string agent_iri;
  int window = 0;
  NavGraphStamp stamp;
  std::string previous_hash;  // Graph of the previous window; empty = start.
  std::uint64_t cycle = 0;
  double began_s = 0.0;  // Earliest begin of planning [Unix s].
};

// Whether the graph leaves from the start, or its predecessor is known.
bool IsJoined(const NavGraphOrigin& origin,
              const kg_compiler::SeamRules& rules);

// Stages the graph's node and the planner's activity, unless already known. No
// effect if the compilation lacks the agent or window, or the graph's
// predecessor is unknown.
void StageNavGraph(const NavGraphOrigin& origin,
                   const kg_compiler::Compilation& compilation,
                   kg_core::Transaction* transaction);

// Run and predecessor of a graph among the facts.
struct NavGraphPlace {
  unsigned long long run = 0;
  // Graph of the previous window; empty = edges leave from `start_iri`.
  std::string previous_hash;
  std::string start_iri;
};

// Waypoints, edges and edge costs of one graph.
std::vector<kg_core::Statement> NavGraphStatements(
    const kg_compiler::NavGraph& graph, const NavGraphPlace& place);

// Description of the graph: class, agent, window, mode, hash.
std::vector<kg_core::Statement> NavGraphDescription(
    const NavGraphOrigin& origin, const kg_mission::Mission& mission);

// One ex:EdgeCost, in `graph`.
std::vector<kg_core::Statement> EdgeCostStatements(
    const kg_core::Term& graph, const kg_core::Term& edge,
    const std::string& agent_iri, const kg_compiler::EdgeCost& cost);

}  // namespace kg_engine

#endif  // KG_ENGINE_FACTS_NAV_GRAPH_FACTS_H_
