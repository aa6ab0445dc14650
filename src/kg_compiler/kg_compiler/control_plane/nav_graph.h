// The control plane, Phi 1, as it runs for one agent: waypoints of every window
// within reach, and the seams between those of consecutive windows, each flown.
//
// Window t's waypoints are sampled from U_t where the agent can be by the end
// of t, having been at one of window t-1's waypoints (or its start) at the
// begin of t, plus the reachable events of the window and the places it can
// stay at. A seam into window t leaves when t begins and arrives before it
// ends.
//
//   S = lambda_time t + lambda_energy E + lambda_risk H + lambda_unc (1 - w)
//
// with the flight's time t, energy E and hazard H, and w of the window one
// arrives in (A55). Waypoints: the window's events that can be flown to, then
// picks of Proximal Recurrence (within reach, station held until the window
// ends), at most max_waypoints; where fewer than three can be flown to, also
// the places one can stay at. What has no edge into it is left out.

#ifndef KG_COMPILER_CONTROL_PLANE_NAV_GRAPH_H_
#define KG_COMPILER_CONTROL_PLANE_NAV_GRAPH_H_

#include <string>
#include <vector>

#include "kg_compiler/control_plane/seam_rules.h"
#include "kg_compiler/data_plane/mission_tensor.h"
#include "kg_compiler/traversal/traversal.h"
#include "kg_core/raster/vector_field.h"

namespace kg_compiler {

struct Waypoint {
  int id = 0;  // Index within its window's graph.
  kg_core::LonLat position;
  double score = 0.0;  // PR response: sum of FUSED over the footprint (A12).
  double value = 0.0;  // FUSED at the waypoint, in [0, 1].
  std::vector<std::string> events;  // IRIs of the events a visit here counts.
  double event_reward = 0.0;        // Their rewards' sum.
  std::vector<int> footprint = {};  // Cells of the grid that the score sums.
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
  // Of everything it is made of: the rules it follows, the tensor, the field
  // and the places one comes from.
  std::string hash;
};

// S of a flight into a window of confidence w, in reward units.
double SeamCost(const SeamWeights& weights, const Flight& flight,
                double confidence);

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

#endif  // KG_COMPILER_CONTROL_PLANE_NAV_GRAPH_H_
