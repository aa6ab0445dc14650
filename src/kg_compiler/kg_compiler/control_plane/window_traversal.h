// Traversal within one window for one agent: where it may be, what is
// dangerous, and what a flight there costs it. The only caller of traversal in
// planning.

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

// Holds references to what it is made of, which must outlive it.
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

  // See traversal.h; departures are at the window's begin.
  double HoldableFrom_s(kg_base::LonLat place) const;
  ReachMap ReachFrom(kg_base::LonLat source) const;
  // Nothing if it cannot be flown. `reach` is that of `source`.
  std::optional<FlownPath> Fly(kg_base::LonLat source, const ReachMap& reach,
                               kg_base::LonLat to) const;

  // A walk from `source`: along the tracks of these flights, one after the
  // other, each from when the one before has arrived; at their own speeds, or
  // all at cruise speed if they cannot be flown so. Its isolation is that of
  // its end. Stops, from and to not set.
  std::optional<TraverseEdge> FlyWalk(kg_base::LonLat source,
                                      const std::vector<const FlownPath*>& legs,
                                      double isolation) const;
  // 0 off the grid.
  double HazardAt(kg_base::LonLat place) const;

  // Hash of all but places and surface that reaches and flights depend on.
  std::string Terms() const;
  // Hazard looks so much farther than `read`, the box of a reach, for what is
  // not open.
  CellBox HazardBox(const CellBox& read) const;

  // I of a place, for a second under way: the hazard of having few of the
  // `waypoints` to go to instead (nav_graph.h). The place itself is not one.
  double Isolation(kg_base::LonLat place,
                   const std::vector<kg_base::LonLat>& waypoints) const;
  // The edge of a flight, from and to not set.
  TraverseEdge Price(FlownPath flight, double isolation) const;

 private:
  VoyageRequest VoyageFrom(kg_base::LonLat source) const;

  const SeamRules& rules_;
  const WindowRules& window_;
  const kg_base::Grid& grid_;
  WindowSurface surface_;
  HazardMap hazard_;
  const kg_base::VectorField& field_;
};

// A way between two places in one window, by way of others or not.
struct WaypointRoute {
  kg_base::LonLat from;
  kg_base::LonLat to;
  std::vector<kg_base::LonLat> via = {};
};

// What each of `ways` costs, as it would be priced in a graph of these
// waypoints; nothing where it cannot be flown. `via` of the edges is not set.
std::vector<std::optional<TraverseEdge>> PriceWays(
    const WindowTraversal& traversal, const std::vector<WaypointRoute>& ways,
    const std::vector<kg_base::LonLat>& waypoints);

}  // namespace kg_compiler

#endif  // KG_COMPILER_CONTROL_PLANE_WINDOW_TRAVERSAL_H_
