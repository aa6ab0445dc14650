// What is known of a window's value layer B once, for all tensors made of it:
// the grid's scales, where it has gaps, and how large B and its frontness are
// in each tile, so that their maxima over the open cells of any tensor (A16)
// cost a look at a tile or two, not a pass.

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

// How a grid is cut into tiles: kBandRows rows by at most kTileCols columns, as
// even as whole vectors allow.
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
  int width = 0;   // Of a tile, in columns.
  int across = 0;  // Tiles in a row.
};

class LayerTable {
 public:
  // Keeps no reference to `value`, but must always be asked with it.
  LayerTable(const kg_base::Grid& grid, const kg_base::Raster& value);

  const TileLayout& tiling() const { return tiling_; }
  // The largest |B|, 0 if there is none.
  float max_abs() const { return max_abs_; }

  // What a pass is made of beyond the layers, see PassRow; all at its first
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
  using Tiles = std::vector<float>;  // The largest in each, wherever.
  void FindGaps(const kg_base::Raster& value);
  FrontRows RowsAt(const kg_base::Raster& value, int row, int col) const;
  // F where the neighbourhood has gaps, made once: row after row of the tiles
  // with gaps, and the first and the last column.
  struct GapFronts {
    std::once_flag made;
    std::vector<std::size_t> begin;  // By row and tile across.
    std::vector<float> values;
    std::vector<float> first, last;  // By row.
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
  std::vector<float> deg_per_km_;    // Of longitude, by row.
  std::vector<float> per_km_;        // By row: from the row before to the next.
  std::vector<float> per_km_after_;  // By row: to the next one.
  std::vector<float> per_deg_;       // By column, likewise, in degrees.
  std::vector<float> per_deg_after_;
  std::vector<unsigned char> gaps_;  // By row and tile across.
  float max_abs_ = 0.0f;
  Tiles values_;
  mutable std::once_flag made_[2];  // By operator, when first asked for.
  mutable Tiles fronts_[2];
  mutable GapFronts gap_fronts_[2];
};

}  // namespace kg_compiler

#endif  // KG_COMPILER_DATA_PLANE_LAYER_TABLE_H_
