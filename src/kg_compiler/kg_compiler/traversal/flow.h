// The current as extremals feel it: c = boost_gain current with its exact
// gradients, bilinear in cell units and linear in time, and the scale of
// WGS84. Missing corners count as no flow (vector_field.h); beyond the outer
// centres the outer cell holds.

#ifndef KG_COMPILER_TRAVERSAL_FLOW_H_
#define KG_COMPILER_TRAVERSAL_FLOW_H_

#include <climits>
#include <vector>

#include "kg_compiler/traversal/traversal.h"

namespace kg_compiler {

class Flow {
 public:
  explicit Flow(const Voyage& voyage);  // Must outlive it.

  // The slices around a time [s after the departure's].
  struct Moment {
    const float *east0, *north0, *east1, *north1;
    double share;  // Of the second slice.
  };
  Moment At(double time_s) const;
  // The first slice's time after `time_s`; infinite after the last.
  double NextSlice_s(double time_s) const;

  struct Sample {
    double east, north;                   // [m/s]
    double east_col, north_col;           // Per cell step eastwards [m/s].
    double east_row, north_row;           // Per cell step northwards [m/s].
    double lon_per_m, lat_per_m;          // Degrees per metre here,
    double lon_per_m_row, lat_per_m_row;  // and their change per row.
    double cols_per_deg, rows_per_deg;
  };
  // Position in cell units; must be on the grid.
  Sample operator()(const Moment& moment, double col, double row) const;

  // Degrees per cell step at a position.
  double DegPerCol(double col) const {
    return 1.0 / cols_per_deg_[Lower(col, cols_)];
  }
  double DegPerRow(double row) const {
    return 1.0 / rows_per_deg_[Lower(row, rows_)];
  }
  // Degrees per metre at a row.
  kg_core::LonLat Scale(double row) const;

  const kg_core::Grid& grid() const { return field_.grid; }
  // The cells that were asked for since it was made.
  const CellBox& felt() const { return felt_; }

 private:
  static int Lower(double at, int size) {
    const int i = at > 0.0 ? static_cast<int>(at) : 0;
    return i < size - 2 ? i : size - 2;
  }
  void Interpolate(const Moment& moment, std::size_t corner, double north,
                   double east, Sample* at) const;
  void FillScale(int row) const;

  const kg_core::VectorField& field_;
  double gain_;
  double epoch_s_;
  int rows_, cols_;
  std::vector<double> slice_s_;  // After the departure's time.
  std::vector<double> cols_per_deg_, rows_per_deg_;  // By interval.
  // By row, made when first asked for (0 = not yet).
  mutable std::vector<double> lon_per_m_, lat_per_m_;
  mutable CellBox felt_{INT_MAX, 0, INT_MAX, 0};
};

}  // namespace kg_compiler

#endif  // KG_COMPILER_TRAVERSAL_FLOW_H_
