// A half-open rectangle of cells: extent of sparse masks, updates, reaches and
// cache entries.

#ifndef KG_COMPILER_DATA_PLANE_CELL_BOX_H_
#define KG_COMPILER_DATA_PLANE_CELL_BOX_H_

#include <algorithm>
#include <cstddef>

#include "kg_base/raster/grid.h"

namespace kg_compiler {

struct CellBox {
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

inline CellBox WholeGrid(const kg_base::Grid& grid) {
  return {0, grid.rows(), 0, grid.cols()};
}

inline CellBox Common(const CellBox& a, const CellBox& b) {
  return {std::max(a.row, b.row), std::min(a.row_end, b.row_end),
          std::max(a.col, b.col), std::min(a.col_end, b.col_end)};
}

inline CellBox Moved(const CellBox& box, int cells) {
  return {box.row + cells, box.row_end + cells, box.col + cells,
          box.col_end + cells};
}

// The smallest box that contains both; empty boxes are ignored.
inline CellBox Join(const CellBox& a, const CellBox& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  return {std::min(a.row, b.row), std::max(a.row_end, b.row_end),
          std::min(a.col, b.col), std::max(a.col_end, b.col_end)};
}

// The box extended by `rows` and `cols` on every side, clipped to the grid. A
// box without rows grows as well: it is a line between cells.
inline CellBox Grown(const CellBox& box, int rows, int cols,
                     const kg_base::Grid& grid) {
  return Common(
      {box.row - rows, box.row_end + rows, box.col - cols, box.col_end + cols},
      WholeGrid(grid));
}
inline CellBox Grown(const CellBox& box, int cells, const kg_base::Grid& grid) {
  return Grown(box, cells, cells, grid);
}

}  // namespace kg_compiler

#endif  // KG_COMPILER_DATA_PLANE_CELL_BOX_H_
