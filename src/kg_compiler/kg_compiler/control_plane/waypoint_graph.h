// The navigation graph of one (agent, window): waypoints, and the flown edges
// to them. Values only; nav_graph.h describes how they are built and priced.

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
  std::vector<std::string> events;  // IRIs of the events visited here.
  double event_reward = 0.0;        // Sum of their rewards.
  std::vector<int> footprint = {};  // Grid cells summed in the score.
};

// A directed edge to a waypoint of this graph's window, with its cost
// (ex:EdgeCost).
struct TraverseEdge {
  int from = 0;      // Waypoint id of the previous window; 0 = start if first.
                     // Inner edge: waypoint id of this window.
  int to = 0;        // Waypoint id of this window.
  FlownPath flight;  // The whole path, including stops.
  double seam_cost = 0.0;    // S, in reward units.
  double isolation_s = 0.0;  // I.
  // X, time integral along the flight of each of kg_mission's CostQuantities()
  // [unit s]; empty where the window's field has none.
  std::vector<double> exposures = {};
  // T, angle between the agent's start heading and the course over ground on
  // which the flight leaves the start, in [0, pi]. 0 for edges that do not
  // leave the start, for flights that stay there, and if turns have no price.
  double turn_rad = 0.0;
  // Waypoints of this window visited on the way, in order: a walk.
  std::vector<int> via = {};
};

struct NavGraph {
  std::string agent_iri;
  int window = 0;
  MovementMode movement_mode = MovementMode::kHops;
  std::vector<Waypoint> waypoints;
  std::vector<TraverseEdge> edges;  // Sorted by (from, to, via).
  // Mode "edges": edges between waypoints of this window, sorted by (from, to).
  std::vector<TraverseEdge> inner_edges;
  // Hash of all inputs: rules, tensor, field and departure places.
  std::string hash;
};

// Finds an edge among `edges`; null = there is no such edge.
const TraverseEdge* FindEdge(const NavGraph& graph, int from, int to,
                             const std::vector<int>& via);

// Waypoint ids that an edge visits, in order; the last is its end.
std::vector<int> StopsOf(const TraverseEdge& edge);

// One window's rasters as published.
struct WindowWorld {
  const MissionTensor* tensor = nullptr;
  const kg_base::VectorField* field = nullptr;
};

// Positions of the waypoints, in the same order.
std::vector<kg_base::LonLat> PositionsOf(
    const std::vector<Waypoint>& waypoints);

}  // namespace kg_compiler

#endif  // KG_COMPILER_CONTROL_PLANE_WAYPOINT_GRAPH_H_
