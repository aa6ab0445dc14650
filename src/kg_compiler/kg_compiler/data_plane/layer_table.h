// Precomputed data of a window's value layer B, shared by all its tensors: the
// grid's scales, the gaps, and the maxima of B and its frontness in each tile,
// so that the maxima over the open cells of any tensor (A16) need only one or
// two tiles instead of a full pass.

#ifndef KG_COMPILER_DATA_PLANE_LAYER_TABLE_H_
#define KG_COMPILER_DATA_PLANE_LAYER_TABLE_H_

#include <memory>
#include <mutex>
#include <vector>

#include "kg_base/raster/grid.h"
#include "kg_compiler/data_plane/bands.h"
#include "kg_compiler/data_plane/cell_box.h"
#include "kg_compiler/data_plane/row_kernels.h"
#include "kg_mission/mission/mission.h"

namespace kg_compiler {

// Partition of a grid into tiles of kBandRows rows by at most kTileCols
// columns, with widths as equal as whole vectors allow.
struct TileLayout {
  TileLayout() = default;
  TileLayout(int grid_rows, int grid_cols) : rows(grid_rows), cols(grid_cols) {
    const int wanted = (cols + kTileCols - 1) / kTileCols;
    width = ((cols + wanted - 1) / wanted + 31) / 32 * 32;
    across = (cols + width - 1) / width;
  }
  int bands() const { return (rows + kBandRows - 1) / kBandRows; }
  int size() const { return bands() * across; }
  CellBox Box(int tile) const;

  int rows = 0;
  int cols = 0;
  int width = 0;   // Width of a tile [columns].
  int across = 0;  // Tiles in a row.
};

class LayerTable {
 public:
  // Keeps no reference to `value`; all calls must pass the same raster.
  LayerTable(const kg_base::Grid& grid, const kg_base::Raster& value);

  const TileLayout& tiling() const { return tiling_; }
  // The largest |B|, 0 if there is none.
  float max_abs() const { return max_abs_; }

  // Inputs of a pass besides the layers, see PassRow; pointers are to its first
  // column. Columns [col, col + n) of a row, within one tile.
  struct Weights {
    float base = 0.0f;
    float front = 0.0f;
    kg_mission::FrontOperator op = kg_mission::FrontOperator::kSobel;
  };
  ValueExtremes Pass(const kg_base::Raster& value, const Weights& weights,
                     kg_base::Cell first, int n, PassRow row, float* y) const;

  // The largest B or F of an open cell, 0 if none is positive.
  float MaxOpenValue(const kg_base::Raster& value,
                     const RowBands<unsigned char>& state) const;
  float MaxOpenFront(const kg_base::Raster& value, kg_mission::FrontOperator op,
                     const RowBands<unsigned char>& state) const;

 private:
  using Tiles = std::vector<float>;  // Maximum per tile over all cells.
  void FindGaps(const kg_base::Raster& value);
  FrontRows RowsAt(const kg_base::Raster& value, int row, int col) const;
  // F where the neighbourhood has gaps, computed once: the rows of tiles with
  // gaps in sequence, and the first and the last column.
  struct GapFronts {
    std::once_flag made;
    std::vector<std::size_t> begin;  // Offset in values, by row and tile.
    std::vector<float> values;
    std::vector<float> first, last;  // F of the outermost columns, per row.
  };
  const GapFronts& GapFrontsOf(const kg_base::Raster& value,
                               kg_mission::FrontOperator op) const;
  const Tiles& FrontTiles(const kg_base::Raster& value,
                          kg_mission::FrontOperator op) const;
  // F of columns [col, col + n) of a row, within one tile.
  void Fronts(const kg_base::Raster& value, kg_mission::FrontOperator op,
              kg_base::Cell first, int n, float* f) const;
  bool HasGaps(int row, int col) const {
    return gaps_[static_cast<std::size_t>(row) * tiling_.across +
                 col / tiling_.width] != 0;
  }
  template <typename Evaluate>
  float MaxOpen(const Tiles& tiles, const RowBands<unsigned char>& state,
                const Evaluate& evaluate) const;

  TileLayout tiling_;
  std::vector<float> deg_per_km_;    // Degrees of longitude per km, by row.
  std::vector<float> per_km_;        // By row: previous to next row [1/km].
  std::vector<float> per_km_after_;  // By row: this to next row [1/km].
  std::vector<float> per_deg_;       // By column, likewise [1/deg].
  std::vector<float> per_deg_after_;
  std::vector<unsigned char> gaps_;  // 1 = has gaps, by row and tile.
  float max_abs_ = 0.0f;
  Tiles values_;
  mutable std::once_flag made_[2];  // By operator, set on first use.
  mutable Tiles fronts_[2];
  mutable GapFronts gap_fronts_[2];
};

}  // namespace kg_compiler

#endif  // KG_COMPILER_DATA_PLANE_LAYER_TABLE_H_
