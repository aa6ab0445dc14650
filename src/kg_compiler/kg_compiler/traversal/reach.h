// The cells that can be reached before a deadline, with the earliest arrival at
// each, and the corners around which the extremals go (fan.h computes them).

#ifndef KG_COMPILER_TRAVERSAL_REACH_H_
#define KG_COMPILER_TRAVERSAL_REACH_H_

#include <memory>
#include <vector>

#include "kg_base/raster/grid.h"
#include "kg_compiler/data_plane/cell_box.h"

namespace kg_compiler {

// A reachable cell with the earliest arrival found.
struct ReachedCell {
  double arrival_s = 0.0;    // At its centre, seconds after departure.
  int index = 0;             // Grid index of the cell.
  int root = 0;              // Root of the extremal that arrives first.
  float heading_rad = 0.0f;  // Its heading at the root, ccw from east.
  float spread_rad = 0.0f;   // Heading difference of the bracketing rays.
};

// A start of extremals: the departure, or a corner of a closed region that
// tracks go round.
struct ReachRoot {
  kg_base::GridPoint place;
  double time_s = 0.0;  // Seconds after the departure.
  int parent = -1;      // The root from which it is reached; -1 = departure.
  double heading_rad = 0.0;  // Heading at the parent that leads here.
  double spread_rad = 0.0;   // Heading difference of the bracketing rays.
};

class SlowerReaches;

struct ReachMap {
  std::vector<ReachedCell> cells;  // Ascending by index.
  std::vector<ReachRoot> roots;    // The departure first.
  double cells_per_s = 0.0;        // Largest speed over ground met.
  // Box outside of which neither this reach nor any flight that Traverse finds
  // with it reads the world's `open` or field. (Hazard at a cell inside depends
  // on the open cells within HazardMap::kRanges ranges.)
  CellBox read;
  // Reaches at slower speeds, computed on demand; null if energy has no price.
  std::shared_ptr<SlowerReaches> slower;

  const ReachedCell* Find(int index) const;  // Null = not reached.
};

}  // namespace kg_compiler

#endif  // KG_COMPILER_TRAVERSAL_REACH_H_
