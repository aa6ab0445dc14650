// A rectangle of cells, half open: what sparse masks and updates are about.

#ifndef KG_COMPILER_DATA_PLANE_GRID_BOX_H_
#define KG_COMPILER_DATA_PLANE_GRID_BOX_H_

#include <algorithm>
#include <cstddef>

#include "kg_core/raster/grid.h"

namespace kg_compiler {

struct GridBox {
  int row = 0;
  int row_end = 0;
  int col = 0;
  int col_end = 0;

  int rows() const { return row_end - row; }
  int cols() const { return col_end - col; }
  bool empty() const { return !(rows() > 0 && cols() > 0); }
  std::size_t size() const {
    return empty() ? 0 : static_cast<std::size_t>(rows()) * cols();
  }
  bool HasRow(int r) const { return r >= row && r < row_end; }
};

inline GridBox WholeGrid(const kg_core::Grid& grid) {
  return {0, grid.rows(), 0, grid.cols()};
}

inline GridBox Common(const GridBox& a, const GridBox& b) {
  return {std::max(a.row, b.row), std::min(a.row_end, b.row_end),
          std::max(a.col, b.col), std::min(a.col_end, b.col_end)};
}

inline GridBox Grown(const GridBox& box, int cells, const kg_core::Grid& grid) {
  return Common({box.row - cells, box.row_end + cells, box.col - cells,
                 box.col_end + cells},
                WholeGrid(grid));
}

}  // namespace kg_compiler

#endif  // KG_COMPILER_DATA_PLANE_GRID_BOX_H_
