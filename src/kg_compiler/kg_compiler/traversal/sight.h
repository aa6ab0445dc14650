// Cells that may be entered, and line-of-sight tests between positions.

#ifndef KG_COMPILER_TRAVERSAL_SIGHT_H_
#define KG_COMPILER_TRAVERSAL_SIGHT_H_

#include <array>
#include <vector>

#include "kg_compiler/data_plane/cell_box.h"
#include "kg_compiler/traversal/voyage.h"

namespace kg_compiler {

inline bool Holds(const CellBox& box, kg_base::Cell cell) {
  return cell.row >= box.row && cell.row < box.row_end && cell.col >= box.col &&
         cell.col < box.col_end;
}

inline bool IsWithin(const CellBox& a, const CellBox& b) {
  return a.row >= b.row && a.row_end <= b.row_end && a.col >= b.col &&
         a.col_end <= b.col_end;
}

// The cell a position lies in, for any position: outside of the grid the
// nearest cell along each axis, for NaN the first.
inline kg_base::Cell CellOf(const kg_base::Grid& grid, kg_base::GridPoint at) {
  return {kg_base::HeldFloor(at.row + 0.5, grid.rows() - 1),
          kg_base::HeldFloor(at.col + 0.5, grid.cols() - 1)};
}

class LineOfSight {
 public:
  // Cells outside `box` or the grid count as closed. The world, whose field
  // has at least one slice, must outlive this object.
  LineOfSight(const TraversalWorld& world, const CellBox& box);

  // Is the cell in the box, open, and with a known current?
  bool IsOpen(kg_base::Cell cell) const {
    if (!Holds(box_, cell)) return false;
    const std::size_t i = grid_.Index(cell);
    return open_[i] == 1 && east_mps_[i] == east_mps_[i];  // NaN = no data.
  }
  // Does the position lie on the grid and in the box?
  bool Contains(kg_base::GridPoint at) const {
    return at.row > box_.row - 0.5 && at.row < box_.row_end - 0.5 &&
           at.col > box_.col - 0.5 && at.col < box_.col_end - 0.5;
  }
  // Is the straight line from a to b (in cell units) free? Every cell it
  // touches must be open, including both cells beside a corner it passes; the
  // cell of `a` is not tested. False if b is not in the box or a not finite.
  bool IsClear(kg_base::GridPoint a, kg_base::GridPoint b) const;

  // Is a cell of a block of kBlock by kBlock, or one beside it, closed? True
  // outside of the grid.
  static constexpr int kBlock = 4;
  bool NearClosed(kg_base::Cell cell);

  // Corners of closed cells that a track may go round, from an open cell: bit
  // k is set if the cell diagonally kDiagonals[k] is closed, those beside it
  // open. Such a corner is passed at CornerAt, just inside of the cell.
  static constexpr std::array<kg_base::Cell, 4> kDiagonals = {
      {{1, 1}, {1, -1}, {-1, 1}, {-1, -1}}};
  unsigned Corners(kg_base::Cell cell) const;
  static kg_base::GridPoint CornerAt(kg_base::Cell cell, int diagonal);

 private:
  bool FindClosed(int block_row, int block_col) const;

  const kg_base::Grid& grid_;
  const kg_base::Mask& open_;
  const kg_base::Raster& east_mps_;
  CellBox box_;
  int block_cols_;
  // Per block: 1, 0, or -1 = not computed yet.
  std::vector<signed char> near_closed_;
};

}  // namespace kg_compiler

#endif  // KG_COMPILER_TRAVERSAL_SIGHT_H_
