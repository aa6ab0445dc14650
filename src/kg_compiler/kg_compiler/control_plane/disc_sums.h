// R = U * disc_r: sums of a raster over discs in metres, on exact integers, so
// that the order of summing never shows and equal discs tie.
//
//   R(row, col) = sum over rows b of the disc of P_b(col + h + 1) - P_b(col -
//   h)
//
// with P_b the prefix sums of row b and h the half width, in cells, that the
// disc has there (h differs by column where columns are not evenly spaced).
// Prefix sums are made for a strip of columns at a time and of as many rows as
// a disc has, so that they stay in the cache.

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
  static constexpr int kStrip = 128;  // Most columns of a strip.
  static constexpr int kGroup = 16;   // Columns that are summed at once.

  struct Run {  // P_b from the first column's west and east end on.
    const std::int64_t* west;
    const std::int64_t* east;
  };

  // Sums of `values` over the discs around the cells of a box, `rows` by
  // `cols`, neither empty. Values that are not > 0 count 0, and others are
  // rounded to multiples of unit(). Reads the box, what discs around it see and
  // a column more. Holds references to the grid and the values.
  DiscSums(const kg_base::Grid& grid, const kg_base::Raster& values,
           double radius_m, Span rows, Span cols);

  // A power of two: 2^-31 of one that is above the largest value.
  double unit() const { return unit_; }
  // Everything that is read.
  Span rows() const { return discs_.rows(); }
  Span cols() const { return cols_; }
  // Centres whose discs may see one of these rows or columns.
  Span RowsThatSee(Span rows) const;
  Span ColumnsThatSee(Span cols) const;

  // Values of a row become 0. Not between Sum()s of one strip.
  void Clear(int row, Span cols);
  // From now on centres in these columns are asked for, kStrip at most.
  void BeginStrip(Span cols);
  // The sums [unit()] around the cells of `row` in `cols`, which lie in the
  // strip, into `sums`: room for a multiple of kGroup.
  void Sum(int row, Span cols, std::int64_t* sums);
  // The cells of a disc that are worth anything, ascending.
  std::vector<int> Footprint(kg_base::Cell centre) const;

 private:
  float Largest() const;
  void MeasureDiscs(Span rows);
  // Values of a row in units, 0 where cleared, into `units`.
  void Units(int row, Span cols, std::int32_t* units) const;
  // P of a row: entry i is the sum west of column strip_.first + i.
  const std::int64_t* Prefix(int row);
  void AddUneven(int row, Span cols, int other, std::int64_t* sums);

  const kg_base::Grid& grid_;
  Discs discs_;
  Span centre_rows_, centre_cols_;
  Span cols_;  // Columns that are read.
  const kg_base::Raster& values_;
  double unit_ = 1.0;
  double per_unit_ = 1.0;
  std::vector<std::vector<Span>> cleared_;  // By row of rows().

  // By centre row: its disc's rows, and where their half widths begin.
  std::vector<Span> disc_rows_;
  std::vector<std::size_t> first_width_;
  std::vector<int> widths_;  // kUneven: by column.
  int widest_ = 0;
  int most_rows_ = 0;

  Span strip_;  // Columns that Prefix() covers.
  std::size_t prefix_size_ = 0;
  std::vector<std::int64_t> prefixes_;  // most_rows_ of them, by turns.
  std::vector<int> prefix_row_;         // Whose each is; -1: nobody's.
  std::vector<std::int32_t> units_;     // Of the row that is summed.
  std::vector<Run> runs_;
  std::vector<Span> uneven_;
};

}  // namespace kg_compiler

#endif  // KG_COMPILER_CONTROL_PLANE_DISC_SUMS_H_
