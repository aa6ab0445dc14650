// A planner's waypoint graph, with the cycle and agent it belongs to.

#ifndef KG_ENGINE_PLANNING_AGENT_GRAPH_H_
#define KG_ENGINE_PLANNING_AGENT_GRAPH_H_

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "kg_compiler/control_plane/nav_graph.h"

namespace kg_engine {

struct AgentGraph {
  double made_s = 0.0;  // Unix seconds.
  std::uint64_t world_version = 0;
  std::uint64_t cycle = 0;
  std::string agent;                                   // ex:id.
  std::shared_ptr<const kg_compiler::NavGraph> graph;  // Never null.
  // By edge of graph->edges: chosen for a later gain (A45). Empty = none.
  std::vector<bool> staging;

  int window() const { return graph->window; }
};

}  // namespace kg_engine

#endif  // KG_ENGINE_PLANNING_AGENT_GRAPH_H_
