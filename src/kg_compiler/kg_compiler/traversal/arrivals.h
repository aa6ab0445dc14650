// Earliest arrivals at cell centres, in tiles allocated on first access: a fan
// that stays near its source costs nothing for the rest of the grid.

#ifndef KG_COMPILER_TRAVERSAL_ARRIVALS_H_
#define KG_COMPILER_TRAVERSAL_ARRIVALS_H_

#include <limits>
#include <memory>
#include <stdexcept>
#include <vector>

#include "kg_compiler/traversal/reach.h"

namespace kg_compiler {

class ArrivalTiles {
 public:
  struct Node {
    double arrival_s = std::numeric_limits<double>::infinity();
    int root = 0;
    float heading_rad = 0.0f;
    float spread_rad = 0.0f;
  };

  explicit ArrivalTiles(const kg_base::Grid& grid);

  // Throws std::logic_error for a cell outside of the grid.
  Node& At(kg_base::Cell cell) {
    if (!grid_.Contains(cell)) throw std::logic_error("no such cell");
    auto& tile = tiles_[TileOf(cell)];
    if (!tile) tile = std::make_unique<Node[]>(kTile * kTile);
    return tile[(cell.row % kTile) * kTile + cell.col % kTile];
  }
  // Infinite where nothing has arrived, and outside of the grid.
  double Arrival_s(kg_base::Cell cell) const {
    if (!grid_.Contains(cell)) return std::numeric_limits<double>::infinity();
    const auto& tile = tiles_[TileOf(cell)];
    return tile ? tile[(cell.row % kTile) * kTile + cell.col % kTile].arrival_s
                : std::numeric_limits<double>::infinity();
  }
  // Reached cells, ascending by grid index.
  std::vector<ReachedCell> Reached() const;

 private:
  static constexpr int kTile = 16;
  std::size_t TileOf(kg_base::Cell cell) const {
    return static_cast<std::size_t>(cell.row / kTile) * tile_cols_ +
           cell.col / kTile;
  }

  const kg_base::Grid& grid_;
  int tile_cols_;
  std::vector<std::unique_ptr<Node[]>> tiles_;
};

}  // namespace kg_compiler

#endif  // KG_COMPILER_TRAVERSAL_ARRIVALS_H_
