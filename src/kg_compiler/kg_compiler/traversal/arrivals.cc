#include "kg_compiler/traversal/arrivals.h"

#include <algorithm>

namespace kg_compiler {

ArrivalTiles::ArrivalTiles(const kg_base::Grid& grid)
    : grid_(grid),
      tile_cols_((grid.cols() + kTile - 1) / kTile),
      tiles_(static_cast<std::size_t>(tile_cols_) *
             ((grid.rows() + kTile - 1) / kTile)) {}

std::vector<ReachedCell> ArrivalTiles::Reached() const {
  std::vector<ReachedCell> cells;
  for (int row = 0; row < grid_.rows(); ++row) {
    // Along a row through its tiles, so that indices ascend.
    const std::size_t first = TileOf({row, 0});
    for (int tile = 0; tile < tile_cols_; ++tile) {
      if (!tiles_[first + tile]) continue;
      const Node* nodes = &tiles_[first + tile][(row % kTile) * kTile];
      const int end = std::min(kTile, grid_.cols() - tile * kTile);
      for (int c = 0; c < end; ++c) {
        if (!(nodes[c].arrival_s < std::numeric_limits<double>::infinity())) {
          continue;
        }
        const int index =
            static_cast<int>(grid_.Index({row, tile * kTile + c}));
        cells.push_back({nodes[c].arrival_s, index, nodes[c].root,
                         nodes[c].heading_rad, nodes[c].spread_rad});
      }
    }
  }
  return cells;
}

}  // namespace kg_compiler
