// R = U * disc_r: sums of a raster over discs in metres, in exact integer
// arithmetic, so that results do not depend on the order of summation and equal
// discs tie.
//
//   R(row, col) = sum over rows b of the disc of P_b(col + h + 1) - P_b(col -
//   h)
//
// with P_b the prefix sums of row b and h the half width of the disc in that
// row, in cells (h differs by column where columns are not evenly spaced).
// Prefix sums are computed for one strip of columns at a time and for as many
// rows as a disc covers, so that they stay in the cache.

#ifndef KG_COMPILER_CONTROL_PLANE_DISC_SUMS_H_
#define KG_COMPILER_CONTROL_PLANE_DISC_SUMS_H_

#include <cstddef>
#include <cstdint>
#include <vector>

#include "kg_base/raster/grid.h"
#include "kg_compiler/control_plane/disc.h"

namespace kg_compiler {

class DiscSums {
 public:
  static constexpr int kStrip = 128;  // Largest number of columns of a strip.
  static constexpr int kGroup = 16;   // Columns summed at once.

  struct Run {  // P_b at the west and east end of the first column.
    const std::int64_t* west;
    const std::int64_t* east;
  };

  // Sums `values` over the discs around the cells of the box `rows` x `cols`,
  // neither empty. Values that are not > 0 count as 0, others are rounded to
  // multiples of unit(). Reads the box, the cells covered by discs around it
  // and one more column. Holds references to the grid and the values.
  DiscSums(const kg_base::Grid& grid, const kg_base::Raster& values,
           double radius_m, Span rows, Span cols);

  // Quantisation step: 2^-31 times a power of two above the largest value.
  double unit() const { return unit_; }
  // All rows and columns that are read.
  Span rows() const { return discs_.rows(); }
  Span cols() const { return cols_; }
  // Centres whose discs may cover one of these rows or columns.
  Span RowsThatSee(Span rows) const;
  Span ColumnsThatSee(Span cols) const;

  // Sets values of a row to 0. Must not be called between calls of Sum() for
  // one strip.
  void Clear(int row, Span cols);
  // Selects the strip of centre columns for Sum(), at most kStrip of them.
  void BeginStrip(Span cols);
  // Writes the sums [unit()] around the cells of `row` in `cols`, which lie in
  // the strip, to `sums`, whose size must be a multiple of kGroup.
  void Sum(int row, Span cols, std::int64_t* sums);
  // Indices of the cells of a disc with non-zero value, ascending.
  std::vector<int> Footprint(kg_base::Cell centre) const;

 private:
  float Largest() const;
  void MeasureDiscs(Span rows);
  // Writes the values of a row in units, 0 where cleared, to `units`.
  void Units(int row, Span cols, std::int32_t* units) const;
  // Prefix sums P of a row: entry i is the sum west of column strip_.first + i.
  const std::int64_t* Prefix(int row);
  void AddUneven(int row, Span cols, int other, std::int64_t* sums);

  const kg_base::Grid& grid_;
  Discs discs_;
  Span centre_rows_, centre_cols_;
  Span cols_;  // Columns that are read.
  const kg_base::Raster& values_;
  double unit_ = 1.0;
  double per_unit_ = 1.0;
  // Cleared columns, per row of rows().
  std::vector<std::vector<Span>> cleared_;

  // Per centre row: rows of its disc, and index of their first entry in
  // widths_.
  std::vector<Span> disc_rows_;
  std::vector<std::size_t> first_width_;
  // Half widths [cells]; kUneven = differs by column.
  std::vector<int> widths_;
  int widest_ = 0;
  int most_rows_ = 0;

  Span strip_;  // Columns that Prefix() covers.
  std::size_t prefix_size_ = 0;
  std::vector<std::int64_t> prefixes_;  // Ring buffer of most_rows_ rows.
  std::vector<int> prefix_row_;         // Row cached in each slot; -1 = empty.
  std::vector<std::int32_t> units_;  // Values of the row being summed [unit()].
  std::vector<Run> runs_;
  std::vector<Span> uneven_;
};

}  // namespace kg_compiler

#endif  // KG_COMPILER_CONTROL_PLANE_DISC_SUMS_H_
