// Hazard in [0, 1] near cells that are not open, computed on demand (A20):
//
//   h(x) = max( exp(-d(x) / range), 1 - attenuation(x) )
//
// d [m] from the cell's centre to the nearest centre that is not open
// (distance_transform.h); a cell outside of the grid is not open, its hazard is
// 1; the first term is 0 beyond kRanges ranges (there it
// would be less than 0.0025), so that no cell depends on cells farther away.
// Thread-safe.

#ifndef KG_COMPILER_TRAVERSAL_HAZARD_MAP_H_
#define KG_COMPILER_TRAVERSAL_HAZARD_MAP_H_

#include <memory>
#include <mutex>
#include <vector>

#include "kg_base/raster/grid.h"

namespace kg_compiler {

class HazardMap {
 public:
  static constexpr double kRanges = 6.0;

  // `grid` and `open` must outlive it.
  HazardMap(const kg_base::Grid& grid, const kg_base::Mask& open,
            kg_base::Raster attenuation, double range_m);

  double At(kg_base::Cell cell) const;

 private:
  static constexpr int kTile = 32;
  struct Tile {
    std::once_flag made;
    // First term; empty = no closed cell within reach.
    std::vector<float> near;
  };

  void Make(int tile_row, int tile_col, Tile* tile) const;

  const kg_base::Grid& grid_;
  const kg_base::Mask& open_;
  kg_base::Raster attenuation_;
  double range_m_;
  int tile_cols_;
  std::unique_ptr<Tile[]> tiles_;
};

}  // namespace kg_compiler

#endif  // KG_COMPILER_TRAVERSAL_HAZARD_MAP_H_
