// A plan as facts: what planners and selector answered, written into the run's
// own graph (ex:graph/plan/<run>) with its provenance. Never read by the
// compiler, so an assignment never triggers its own recompilation.
//
//   ex:plan\/7               a ex:PlanRun ; ex:worldVersion ; ex:status ; ...
//   ex:plan\/7\/alpha\/w2    a ex:Assignment ; ex:forAgent ; ex:forWindow ;
//       ex:waypointWKT ; ex:reward ; ex:costHours ; ... ; prov:wasGeneratedBy
//   ex:plan\/7\/rejection\/0 a ex:Rejection ; ...
//   ex:tensor\/<hash>        a ex:HeatmapArtifact ; prov:wasDerivedFrom ...
//   ex:nav\/<hash>           a ex:NavGraph, with waypoints, edges, edge costs

#ifndef KG_ROS_KNOWLEDGE_PLAN_FACTS_H_
#define KG_ROS_KNOWLEDGE_PLAN_FACTS_H_

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "kg_compiler/mission_compiler.h"
#include "kg_core/mission/mission.h"
#include "kg_core/rdf/graph_view.h"
#include "kg_core/rdf/store.h"
#include "kg_msgs/Assignments.h"
#include "kg_msgs/NavGraph.h"
#include "kg_msgs/Rejection.h"

namespace kg_ros {

// A stop that has been made: frozen, copied from run to run.
struct ExecutedVisit {
  std::string agent;  // ex:id.
  std::string agent_iri;
  kg_msgs::Visit visit;
};

struct PlanRecord {
  kg_msgs::Assignments assignments;
  std::vector<kg_msgs::Rejection> rejections;
  std::vector<ExecutedVisit> executed;
  std::map<std::pair<std::string, int>, std::string> nav_graph_hashes;
  double started_s = 0.0;  // Unix seconds.
  double ended_s = 0.0;
};

kg_core::Term PlanGraph(unsigned long long run);
kg_core::Term PlanRunNode(unsigned long long run);

// An edge of the graph with this hash, from and to its waypoints.
kg_core::Term EdgeNode(const std::string& graph_hash, unsigned from,
                       unsigned to);

// The run, its assignments and rejections, and the tensors it used.
std::vector<kg_core::Statement> PlanStatements(
    const PlanRecord& record, const kg_compiler::Compilation& compilation);

// Where a graph stands among the facts.
struct NavGraphPlace {
  unsigned long long run = 0;
  std::string window_iri;
  std::string previous_hash;  // Of the window before; empty: edges leave from
  std::string start_iri;      // this node.
};

// Waypoints, edges and edge costs of one graph.
std::vector<kg_core::Statement> NavGraphStatements(
    const kg_msgs::NavGraph& graph, const NavGraphPlace& place);

// One ex:EdgeCost, in `graph`.
std::vector<kg_core::Statement> EdgeCostStatements(
    const kg_core::Term& graph, const kg_core::Term& edge,
    const std::string& agent_iri, const kg_msgs::EdgeCost& cost);

// The executed stops that the graph of `run` holds, by agent and window.
std::vector<ExecutedVisit> ReadExecuted(const kg_core::GraphView& view,
                                        unsigned long long run,
                                        const kg_core::Mission& mission);

}  // namespace kg_ros

#endif  // KG_ROS_KNOWLEDGE_PLAN_FACTS_H_
