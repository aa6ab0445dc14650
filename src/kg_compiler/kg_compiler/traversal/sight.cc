#include "kg_compiler/traversal/sight.h"

#include <algorithm>
#include <cmath>

namespace kg_compiler {
namespace {

// Distance [cells] at which the corner of a closed cell is passed.
constexpr double kCornerGap = 0.02;

// Next crossing of a cell edge along one axis of the line from a to b, as a
// fraction of the line.
struct AxisWalk {
  AxisWalk(double a, double b, int cell)
      : step(b > a ? 1 : -1),
        per_cell(b != a ? 1.0 / std::abs(b - a) : 2.0),
        next(b != a ? (cell + 0.5 * step - a) / (b - a) : 2.0) {}
  int step;
  double per_cell;
  double next;
};

}  // namespace

LineOfSight::LineOfSight(const TraversalWorld& world, const CellBox& box)
    : grid_(world.field->grid),
      open_(*world.open),
      east_mps_(world.field->slices.front().east_mps),
      box_(Common(box, WholeGrid(grid_))),
      block_cols_((grid_.cols() + kBlock - 1) / kBlock),
      near_closed_(static_cast<std::size_t>(block_cols_) *
                       ((grid_.rows() + kBlock - 1) / kBlock),
                   -1) {}

bool LineOfSight::IsClear(kg_base::GridPoint a, kg_base::GridPoint b) const {
  constexpr double kSame = 1e-9;
  if (!Contains(b) || !std::isfinite(a.row + a.col)) return false;
  kg_base::Cell cell = CellOf(grid_, a);
  const kg_base::Cell last = CellOf(grid_, b);
  AxisWalk row(a.row, b.row, cell.row), col(a.col, b.col, cell.col);
  // Amanatides and Woo's grid traversal: the next edge crossed along either
  // axis, at shares row.next and col.next of the line.
  while (!(cell == last)) {
    if (row.next > 1.0 && col.next > 1.0) return IsOpen(last);
    // The line passes a corner: both cells beside it must be open.
    const bool both = std::abs(row.next - col.next) < kSame;
    const kg_base::Cell up{cell.row + row.step, cell.col};
    const kg_base::Cell beside{cell.row, cell.col + col.step};
    if (both && (!IsOpen(up) || !IsOpen(beside))) return false;
    const bool goes_row = both || row.next < col.next;
    const bool goes_col = both || !goes_row;
    if (goes_row) {
      cell.row += row.step;
      row.next += row.per_cell;
    }
    if (goes_col) {
      cell.col += col.step;
      col.next += col.per_cell;
    }
    if (!IsOpen(cell)) return false;
  }
  return true;
}

bool LineOfSight::FindClosed(int block_row, int block_col) const {
  const int r0 = block_row * kBlock, c0 = block_col * kBlock;
  for (int r = std::max(r0 - 1, 0);
       r <= std::min(r0 + kBlock, grid_.rows() - 1); ++r) {
    for (int c = std::max(c0 - 1, 0);
         c <= std::min(c0 + kBlock, grid_.cols() - 1); ++c) {
      if (!IsOpen({r, c})) return true;
    }
  }
  return false;
}

bool LineOfSight::NearClosed(kg_base::Cell cell) {
  if (!grid_.Contains(cell)) return true;
  const int r = cell.row / kBlock, c = cell.col / kBlock;
  signed char& known =
      near_closed_[static_cast<std::size_t>(r) * block_cols_ + c];
  if (known < 0) known = FindClosed(r, c) ? 1 : 0;
  return known == 1;
}

unsigned LineOfSight::Corners(kg_base::Cell cell) const {
  unsigned corners = 0;
  for (std::size_t k = 0; k < kDiagonals.size(); ++k) {
    const kg_base::Cell d = kDiagonals[k];
    const kg_base::Cell across{cell.row + d.row, cell.col + d.col};
    if (!grid_.Contains(across) || IsOpen(across)) continue;
    if (IsOpen({cell.row + d.row, cell.col}) &&
        IsOpen({cell.row, cell.col + d.col})) {
      corners |= 1u << k;
    }
  }
  return corners;
}

kg_base::GridPoint LineOfSight::CornerAt(kg_base::Cell cell, int diagonal) {
  const kg_base::Cell d = kDiagonals[static_cast<std::size_t>(diagonal)];
  const double away = 0.5 - kCornerGap;
  return {cell.row + away * d.row, cell.col + away * d.col};
}

}  // namespace kg_compiler
