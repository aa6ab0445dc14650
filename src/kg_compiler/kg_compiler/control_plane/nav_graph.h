// The control plane, Phi 1, as it runs for one agent: waypoints of every window
// within reach, and the seams between those of consecutive windows, each flown.
//
// Window t's waypoints are sampled from U_t where the agent can be by the end
// of t, having been at one of window t-1's waypoints (or its start) at the
// begin of t, plus the reachable events of the window and the places it can
// stay at. A seam into window t leaves when t begins and arrives before it
// ends.
//
//   S = lambda_time t + lambda_energy E + lambda_risk (H + I)
//       + lambda_unc (1 - w)
//   I = isolation_weight t / (1 + n)
//
// with the flight's time t, energy E and hazard H, w of the window one arrives
// in (A55), and n the other waypoints of that window within half of the base
// travel of the place one goes to: where one could go instead (A20).
//
// Waypoints: the window's events that can be flown to, then picks of Proximal
// Recurrence (within reach, station held until the window ends), at most
// max_waypoints; where fewer than three can be flown to, also the places one
// can stay at. What has no edge into it is left out.
//
// In the mode "edges" (A22) a graph also has edges between its own waypoints,
// from each to the kInnerNeighbours nearest others that can be flown to. They
// are flown and priced as if one left when the window begins: when one really
// gets there differs by the way one came. Whoever strings them together adds
// the travel_s of a window's edges up and holds them against the window's
// length and base_travel_m / cruise_mps, as each single edge has been, and
// flies what is found from its true departure (kg_selector/paths/walks.h).

#ifndef KG_COMPILER_CONTROL_PLANE_NAV_GRAPH_H_
#define KG_COMPILER_CONTROL_PLANE_NAV_GRAPH_H_

#include <string>
#include <vector>

#include "kg_compiler/control_plane/seam_rules.h"
#include "kg_compiler/data_plane/mission_tensor.h"
#include "kg_compiler/traversal/traversal.h"
#include "kg_core/raster/vector_field.h"

namespace kg_compiler {

inline constexpr int kInnerNeighbours = 4;

struct Waypoint {
  int id = 0;  // Index within its window's graph.
  kg_core::LonLat position;
  double score = 0.0;  // PR response: sum of FUSED over the footprint (A12).
  double value = 0.0;  // FUSED at the waypoint, in [0, 1].
  std::vector<std::string> events;  // IRIs of the events a visit here counts.
  double event_reward = 0.0;        // Their rewards' sum.
  std::vector<int> footprint = {};  // Cells of the grid that the score sums.
};

// A directed edge to a waypoint of this graph's window, with its cost
// (ex:EdgeCost).
struct TraverseEdge {
  int from = 0;  // Waypoint id of the window before; 0 = the start if first.
                 // Of an inner edge: of this window.
  int to = 0;    // Waypoint id of this window.
  FlownPath flight;          // The whole way, stops included.
  double seam_cost = 0.0;    // S, in reward units.
  double isolation_s = 0.0;  // I.
  // Waypoints of this window visited on the way, in order: a walk.
  std::vector<int> via = {};
};

struct NavGraph {
  std::string agent_iri;
  int window = 0;
  MovementMode movement_mode = MovementMode::kHops;
  std::vector<Waypoint> waypoints;
  std::vector<TraverseEdge> edges;  // By (from, to, via).
  // Mode "edges": between waypoints of this window, by (from, to).
  std::vector<TraverseEdge> inner_edges;
  // Of everything it is made of: the rules it follows, the tensor, the field
  // and the places one comes from.
  std::string hash;
};

// Of the graph's edges into the window. Null = there is no such edge.
const TraverseEdge* FindEdge(const NavGraph& graph, int from, int to,
                             const std::vector<int>& via);

// The waypoints that an edge visits, in order; the last is where it ends.
std::vector<int> StopsOf(const TraverseEdge& edge);

// S of an edge into a window of confidence w, in reward units.
double SeamCost(const SeamWeights& weights, const TraverseEdge& edge,
                double confidence);

// One window's rasters as published.
struct WindowWorld {
  const MissionTensor* tensor = nullptr;
  const kg_core::VectorField* field = nullptr;
};

class NavGraphs;
struct SeamCache;

// Builds the graphs of all windows of `rules`, `worlds` in the same order.
// `cache` (may be null) holds what was made the last time, for this agent or
// another, and what is made now. What of it the changes did not touch is taken
// over: whole graphs, and within a window the arrival fields and flights of
// each place; the result is the same bits as without. Throws
// kg_core::InputError if the agent cannot be anywhere by the end of some window
// (naming it), or starts on land or in a no_go area; then the cache is as it
// was.
NavGraphs CompileNavGraphs(const SeamRules& rules,
                           const std::vector<WindowWorld>& worlds,
                           SeamCache* cache);

}  // namespace kg_compiler

#endif  // KG_COMPILER_CONTROL_PLANE_NAV_GRAPH_H_
