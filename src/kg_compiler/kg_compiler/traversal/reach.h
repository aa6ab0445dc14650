// The cells that can be reached before a deadline, with the earliest arrival at
// each, and the corners around which the extremals go (fan.h computes them).

#ifndef KG_COMPILER_TRAVERSAL_REACH_H_
#define KG_COMPILER_TRAVERSAL_REACH_H_

#include <memory>
#include <vector>

#include "kg_base/raster/grid.h"
#include "kg_compiler/data_plane/cell_box.h"

namespace kg_compiler {

// A cell one can be at, with the earliest arrival found.
struct ReachedCell {
  double arrival_s = 0.0;    // At its centre, seconds after departure.
  int index = 0;             // Of the grid.
  int root = 0;              // Where the extremal that comes first set out.
  float heading_rad = 0.0f;  // Through water then, counter-clockwise from east,
  float spread_rad = 0.0f;   // between extremals so far apart.
};

// Where extremals set out: the departure, and the corners of what is closed,
// which tracks go round.
struct ReachRoot {
  kg_base::GridPoint place;
  double time_s = 0.0;  // After the departure.
  int parent = -1;      // The root from which it is reached; -1 = departure.
  double heading_rad = 0.0;  // With which one leaves the parent to get there,
  double spread_rad = 0.0;   // between extremals so far apart.
};

class SlowerReaches;

struct ReachMap {
  std::vector<ReachedCell> cells;  // By index.
  std::vector<ReachRoot> roots;    // The departure first.
  double cells_per_s = 0.0;        // The fastest met.
  // Neither this reach nor any flight that Traverse finds by it reads the
  // world's `open` or field outside of it. (Hazard at a cell in it depends on
  // what is open within HazardMap::kRanges ranges.)
  CellBox read;
  // At slower speeds, made when first needed; null if energy has no price.
  std::shared_ptr<SlowerReaches> slower;

  const ReachedCell* Find(int index) const;  // Null = not reached.
};

}  // namespace kg_compiler

#endif  // KG_COMPILER_TRAVERSAL_REACH_H_
