// Traversal within one window for one agent: open cells, hazard, and the cost
// of flights. The only caller of traversal in planning.

#ifndef KG_COMPILER_CONTROL_PLANE_WINDOW_TRAVERSAL_H_
#define KG_COMPILER_CONTROL_PLANE_WINDOW_TRAVERSAL_H_

#include <optional>
#include <string>
#include <vector>

#include "kg_compiler/control_plane/seam_rules.h"
#include "kg_compiler/control_plane/waypoint_graph.h"
#include "kg_compiler/control_plane/window_surface.h"
#include "kg_compiler/traversal/traversal.h"

namespace kg_compiler {

// Holds references to its constructor arguments, which must outlive it.
class WindowTraversal {
 public:
  WindowTraversal(const SeamRules& rules, const WindowRules& window,
                  const WindowWorld& world);
  WindowTraversal(const WindowTraversal&) = delete;
  WindowTraversal& operator=(const WindowTraversal&) = delete;

  bool IsOpen(kg_base::Cell cell) const;
  const kg_base::Grid& grid() const { return grid_; }
  const WindowSurface& surface() const { return surface_; }
  double begin_s() const { return window_.begin_s; }

  // As in traversal.h, with departures at the begin of the window.
  double HoldableFrom_s(kg_base::LonLat place) const;
  ReachMap ReachFrom(kg_base::LonLat source) const;
  // Nullopt if it cannot be flown. `reach` is the result of ReachFrom(source).
  std::optional<FlownPath> Fly(kg_base::LonLat source, const ReachMap& reach,
                               kg_base::LonLat to) const;

  // Flies a walk from `source` along the tracks of these flights in sequence,
  // each departing when the previous one has arrived, at their own speeds, or
  // all at cruise speed if that is infeasible. Priced as PriceEntry does.
  // Members via, from and to of the result are not set.
  std::optional<TraverseEdge> FlyWalk(kg_base::LonLat source,
                                      const std::vector<const FlownPath*>& legs,
                                      double isolation) const;
  // Hazard at a place in [0, 1]; 0 off the grid.
  double HazardAt(kg_base::LonLat place) const;

  // Hash of all inputs of reaches and flights except places and surface.
  std::string Terms() const;
  // Box in which closed cells affect the hazard inside `read`, the box of a
  // reach.
  CellBox HazardBox(const CellBox& read) const;

  // I of a place per second of travel: the hazard of having few of the
  // `waypoints` as alternatives (nav_graph.h), not counting the place itself.
  double Isolation(kg_base::LonLat place,
                   const std::vector<kg_base::LonLat>& waypoints) const;
  // The priced edge of a flight into the window from its begin; `isolation` is
  // that of the end. from and to are not set.
  TraverseEdge PriceEntry(FlownPath flight, double isolation) const;
  // Likewise for a flight between two waypoints of the window.
  TraverseEdge PriceInner(FlownPath flight, double isolation) const;

 private:
  VoyageRequest VoyageFrom(kg_base::LonLat source) const;
  TraverseEdge Price(FlownPath flight, double isolation, double turn_rad) const;

  const SeamRules& rules_;
  const WindowRules& window_;
  const kg_base::Grid& grid_;
  WindowSurface surface_;
  HazardMap hazard_;
  const kg_base::VectorField& field_;
};

// A route between two places in one window, optionally via others.
struct WaypointRoute {
  kg_base::LonLat from;
  kg_base::LonLat to;
  std::vector<kg_base::LonLat> via = {};
};

// Prices each of `ways` as an edge into the window of a graph of these
// waypoints; nullopt where it cannot be flown. `via` of the edges is not set.
std::vector<std::optional<TraverseEdge>> PriceWays(
    const WindowTraversal& traversal, const std::vector<WaypointRoute>& ways,
    const std::vector<kg_base::LonLat>& waypoints);

}  // namespace kg_compiler

#endif  // KG_COMPILER_CONTROL_PLANE_WINDOW_TRAVERSAL_H_
