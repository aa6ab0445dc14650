// The cells of a grid within a distance of a cell: discs in metres, which are
// ellipses in cells whose shape may differ from row to row.
//
//   north = s(lat_b) - s(lat_a)       s: arc of the meridian from the equator
//   east  = |lon - lon_a| / (degrees per metre eastward at row b)
//   a cell of row b belongs to the disc of a cell of row a if
//   east^2 <= r^2 - north^2

#ifndef KG_COMPILER_CONTROL_PLANE_DISC_H_
#define KG_COMPILER_CONTROL_PLANE_DISC_H_

#include <optional>
#include <vector>

#include "kg_base/raster/grid.h"

namespace kg_compiler {

// Half-open range of rows or columns, [first, last).
struct Span {
  int first = 0;
  int last = 0;

  bool empty() const { return first >= last; }
  int size() const { return last - first; }
  bool Has(int i) const { return first <= i && i < last; }
};
Span Common(Span a, Span b);

// Length of the meridian from the equator to a latitude [m], WGS84: Helmert's
// series, good to a micrometre.
double MeridianArc_m(double lat_deg);

// The discs of one radius [m] around the cells of some rows. Holds a reference
// to the grid.
class Discs {
 public:
  // Throws std::logic_error if the radius is not >= 0.
  Discs(const kg_base::Grid& grid, double radius_m, Span rows);

  double radius_m() const { return radius_m_; }
  // All rows covered by the discs around the centre rows.
  Span rows() const { return known_; }
  // The rows covered by a disc around a cell of `row`, one of the centre rows.
  Span Rows(int row) const;
  // The columns that the disc around a cell covers in row `other`, which is one
  // of Rows().
  Span Columns(kg_base::Cell centre, int other) const;
  // The same around every cell of `centres` in `row`, from west to east.
  void Columns(int row, Span centres, int other, std::vector<Span>* out) const;
  // Half width in row `other` of a disc around a cell of `row` [deg].
  double Reach_deg(int row, int other) const;
  double WidestReach_deg() const;

 private:
  // r^2 - north^2 [m^2] and the east-west scale of row `other`.
  struct Chord {
    double left_m2;
    double m_per_deg;
    bool Sees(double lon_gap_deg) const {
      const double east_m = lon_gap_deg * m_per_deg;
      return east_m * east_m <= left_m2;
    }
  };
  Chord ChordOf(int row, int other) const;

  const kg_base::Grid& grid_;
  double radius_m_;
  Span known_;
  std::vector<double> north_m_;        // Meridian arc of rows known_.
  std::vector<double> m_per_lon_deg_;  // Scale of rows known_.
};

// Columns that are evenly spaced up to the rounding found in files: a reach in
// degrees then covers the same number of cells around every column.
class EvenColumns {
 public:
  explicit EvenColumns(const kg_base::Grid& grid);

  // Number of columns within the reach on either side (away from the edges of
  // the grid); nullopt unless it is certainly equal for all columns.
  std::optional<int> HalfWidth(double reach_deg) const;

 private:
  int cols_;
  double step_deg_;
  double slack_deg_;  // Bound on the difference of equal-step gaps.
};

}  // namespace kg_compiler

#endif  // KG_COMPILER_CONTROL_PLANE_DISC_H_
