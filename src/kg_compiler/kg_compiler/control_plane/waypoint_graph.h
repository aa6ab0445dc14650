// The navigation graph of one (agent, window): waypoints, and the flown edges
// to them. Values only; nav_graph.h says how they are made and priced.

#ifndef KG_COMPILER_CONTROL_PLANE_WAYPOINT_GRAPH_H_
#define KG_COMPILER_CONTROL_PLANE_WAYPOINT_GRAPH_H_

#include <string>
#include <vector>

#include "kg_base/geo/lon_lat.h"
#include "kg_base/raster/vector_field.h"
#include "kg_compiler/control_plane/movement_mode.h"
#include "kg_compiler/data_plane/mission_tensor.h"
#include "kg_compiler/traversal/voyage.h"

namespace kg_compiler {

inline constexpr int kInnerNeighbours = 4;

struct Waypoint {
  int id = 0;  // Index within its window's graph.
  kg_base::LonLat position;
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
  // X, what was met under way of each of kg_core's CostQuantities(), over time
  // [unit s]; empty where the window's field has none.
  std::vector<double> exposures = {};
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

// One window's rasters as published.
struct WindowWorld {
  const MissionTensor* tensor = nullptr;
  const kg_base::VectorField* field = nullptr;
};

// The waypoints' places, in their order.
std::vector<kg_base::LonLat> PositionsOf(
    const std::vector<Waypoint>& waypoints);

}  // namespace kg_compiler

#endif  // KG_COMPILER_CONTROL_PLANE_WAYPOINT_GRAPH_H_
