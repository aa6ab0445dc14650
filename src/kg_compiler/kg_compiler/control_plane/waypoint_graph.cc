#include "kg_compiler/control_plane/waypoint_graph.h"

namespace kg_compiler {

const TraverseEdge* FindEdge(const NavGraph& graph, int from, int to,
                             const std::vector<int>& via) {
  for (const TraverseEdge& edge : graph.edges) {
    if (edge.from == from && edge.to == to && edge.via == via) return &edge;
  }
  return nullptr;
}

std::vector<int> StopsOf(const TraverseEdge& edge) {
  std::vector<int> stops = edge.via;
  stops.push_back(edge.to);
  return stops;
}

std::vector<kg_base::LonLat> PositionsOf(
    const std::vector<Waypoint>& waypoints) {
  std::vector<kg_base::LonLat> positions;
  for (const Waypoint& waypoint : waypoints) {
    positions.push_back(waypoint.position);
  }
  return positions;
}

}  // namespace kg_compiler
