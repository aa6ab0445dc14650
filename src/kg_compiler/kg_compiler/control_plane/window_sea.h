// One window's sea as one agent meets it: where it may be, what is dangerous,
// and what a flight there costs it.

#ifndef KG_COMPILER_CONTROL_PLANE_WINDOW_SEA_H_
#define KG_COMPILER_CONTROL_PLANE_WINDOW_SEA_H_

#include <optional>
#include <vector>

#include "kg_compiler/control_plane/nav_graph.h"

namespace kg_compiler {

// Holds references to what it is made of, which must outlive it.
class WindowSea {
 public:
  WindowSea(const SeamRules& rules, const WindowRules& window,
            const WindowWorld& world);
  WindowSea(const WindowSea&) = delete;
  WindowSea& operator=(const WindowSea&) = delete;

  bool IsOpen(kg_core::Cell cell) const;
  // See traversal.h; departures are at the window's begin.
  double HoldableFrom_s(kg_core::LonLat place) const;
  Reach ReachFrom(kg_core::LonLat source) const;
  // The flight and its price, from and to not set; nothing if it cannot be
  // flown. `reach` is that of `source`.
  std::optional<TraverseEdge> Fly(kg_core::LonLat source, const Reach& reach,
                                  kg_core::LonLat to) const;

 private:
  Voyage VoyageFrom(kg_core::LonLat source) const;

  const SeamRules& rules_;
  const WindowRules& window_;
  const kg_core::Grid& grid_;
  kg_core::Mask open_;
  HazardMap hazard_;
  const kg_core::VectorField& field_;
};

// A way between two places in one window.
struct Way {
  kg_core::LonLat from;
  kg_core::LonLat to;
};

// What each of `ways` costs, as CompileNavGraphs would price it; nothing where
// it cannot be flown.
std::vector<std::optional<TraverseEdge>> PriceWays(
    const WindowSea& sea, const std::vector<Way>& ways);

}  // namespace kg_compiler

#endif  // KG_COMPILER_CONTROL_PLANE_WINDOW_SEA_H_
