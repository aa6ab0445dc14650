// The control plane, Phi 1, as it runs for one agent: waypoints of every window
// within reach, and the seams between those of consecutive windows, each flown.
//
// Window t's waypoints are sampled from U_t where the agent can be by the end
// of t, having been at one of window t-1's waypoints (or its start) at the
// begin of t, plus the reachable events of the window and the places it can
// stay at. A seam into window t leaves when t begins and arrives before it
// ends.

#ifndef KG_COMPILER_NAV_GRAPH_H_
#define KG_COMPILER_NAV_GRAPH_H_

#include <string>
#include <vector>

#include "kg_compiler/mission_tensor.h"
#include "kg_compiler/seam_rules.h"
#include "kg_compiler/traversal.h"
#include "kg_core/raster/vector_field.h"

namespace kg_compiler {

struct Waypoint {
  int id = 0;  // Index within its window's graph.
  kg_core::LonLat position;
  double score = 0.0;  // PR response: sum of FUSED over the footprint (A12).
  double value = 0.0;  // FUSED at the waypoint, in [0, 1].
  std::vector<std::string> events;  // IRIs of the events a visit here counts.
  double event_reward = 0.0;        // Their rewards' sum.
};

// A directed edge into this graph's window, with its cost (ex:EdgeCost).
struct TraverseEdge {
  int from = 0;  // Waypoint id of the window before; 0 = the start if first.
  int to = 0;    // Waypoint id of this window.
  Flight flight;
  double seam_cost = 0.0;  // S, in reward units.
};

struct NavGraph {
  std::string agent_iri;
  int window = 0;
  std::vector<Waypoint> waypoints;
  std::vector<TraverseEdge> edges;  // By (from, to).
  std::string hash;                 // Of everything it is made of.
};

// One window's rasters as published.
struct WindowWorld {
  const MissionTensor* tensor = nullptr;
  const kg_core::VectorField* field = nullptr;
};

// Builds the graphs of all windows of `rules`, `worlds` in the same order.
// Graphs of `previous` whose inputs are unchanged (hash) are reused as they
// are. Throws kg_core::InputError if the agent cannot be anywhere by the end of
// some window (naming it), or starts on land or in a no_go area.
std::vector<NavGraph> CompileNavGraphs(const SeamRules& rules,
                                       const std::vector<WindowWorld>& worlds,
                                       const std::vector<NavGraph>& previous);

}  // namespace kg_compiler

#endif  // KG_COMPILER_NAV_GRAPH_H_
