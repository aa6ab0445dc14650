// The current sampled for extremals: c = boost_gain current with its exact
// gradients, bilinear in cell units and linear in time, and the scale of
// WGS84. Missing corners count as no flow (vector_field.h).
//
// Defined for every position and time, as extremals may leave the grid before
// they are stopped: beyond the outer centres the value is held constant and the
// scale extrapolated linearly; before the first slice and after the last one
// that slice applies. A position or a time that is NaN gives NaN or the last
// slice, never a read outside of the field.

#ifndef KG_COMPILER_TRAVERSAL_FLOW_H_
#define KG_COMPILER_TRAVERSAL_FLOW_H_

#include <Eigen/Core>
#include <algorithm>
#include <climits>
#include <cmath>
#include <vector>

#include "kg_compiler/data_plane/cell_box.h"
#include "kg_compiler/traversal/voyage.h"

namespace kg_compiler {

// Both components, east and north, at the four centres around a position.
struct FlowCorners {
  Eigen::Array2d sw, se, nw, ne;

  FlowCorners(const float* east, const float* north, std::size_t cols)
      : sw(east[0], north[0]),
        se(east[1], north[1]),
        nw(east[cols], north[cols]),
        ne(east[cols + 1], north[cols + 1]) {}
  // Interpolates linearly towards a later slice; `share` in [0, 1].
  void Towards(const FlowCorners& later, double share) {
    sw += share * (later.sw - sw);
    se += share * (later.se - se);
    nw += share * (later.nw - nw);
    ne += share * (later.ne - ne);
  }
  void CalmWhereMissing() {
    for (Eigen::Array2d* corner : {&sw, &se, &nw, &ne}) {
      *corner = corner->isNaN().select(0.0, *corner);
    }
  }
  bool IsMissing() const { return (sw + se + nw + ne).isNaN().any(); }
};

// Bilinear interpolation: value and derivatives per cell step east and north.
struct FlowSlope {
  Eigen::Array2d value, east, north;
};
inline FlowSlope Bilinear(const FlowCorners& c, double north, double east) {
  const Eigen::Array2d south_rise = c.se - c.sw, north_rise = c.ne - c.nw;
  const Eigen::Array2d s = c.sw + east * south_rise;
  const Eigen::Array2d n = c.nw + east * north_rise;
  return {s + north * (n - s), south_rise + north * (north_rise - south_rise),
          n - s};
}

class FlowSampler {
 public:
  // The voyage is kept by reference; its field has at least one slice.
  explicit FlowSampler(const VoyageRequest& voyage);

  // The two slices that bracket a time [s after the departure].
  struct Moment {
    const float *east0, *north0, *east1, *north1;
    double share;  // Weight of the second slice, in [0, 1].
  };
  Moment At(double time_s) const;
  // Time of the first slice after `time_s` [s after the departure]; infinite
  // after the last.
  double NextSlice_s(double time_s) const;

  struct Sample {
    double east, north;           // [m/s]
    double east_col, north_col;   // Derivatives per cell step east [m/s].
    double east_row, north_row;   // Derivatives per cell step north [m/s].
    double lon_per_m, lat_per_m;  // Degrees per metre here,
    double lon_per_m_row, lat_per_m_row;  // and their change per row.
    double cols_per_deg, rows_per_deg;
  };
  // Any position in cell units.
  Sample operator()(const Moment& moment, double col, double row) const;

  // Degrees per cell step at a position.
  double DegPerCol(double col) const { return deg_per_col_[Lower(col, cols_)]; }
  double DegPerRow(double row) const { return deg_per_row_[Lower(row, rows_)]; }
  // Degrees per metre at a row.
  kg_base::LonLat Scale(double row) const;

  const kg_base::Grid& grid() const { return field_.grid; }
  // Box of the cells sampled since construction or the last Forget().
  const CellBox& felt() const { return felt_; }
  void Forget() const { felt_ = kNothing; }

 private:
  // Lower centre of the interval that contains a position on an axis.
  static int Lower(double at, int size) {
    return kg_base::HeldFloor(at, size - 2);
  }
  void Interpolate(const Moment& moment, std::size_t corner, double north,
                   double east, Sample* at) const;
  void FillScale(int row) const;

  const kg_base::VectorField& field_;
  double gain_;
  double epoch_s_;
  int rows_, cols_;
  std::vector<double> slice_s_;  // Slice times [s after the departure].
  // Spacing and its inverse, per interval between centres.
  std::vector<double> deg_per_col_, deg_per_row_;
  std::vector<double> cols_per_deg_, rows_per_deg_;
  // Degrees per metre, by row; computed on first use (0 = not yet).
  mutable std::vector<double> lon_per_m_, lat_per_m_;
  static constexpr CellBox kNothing{INT_MAX, 0, INT_MAX, 0};
  mutable CellBox felt_ = kNothing;
};

// Defined in the header: inlining halves the run time of the extremals.
inline void FlowSampler::Interpolate(const Moment& moment, std::size_t corner,
                                     double north, double east,
                                     Sample* at) const {
  const std::size_t cols = static_cast<std::size_t>(cols_);
  FlowCorners flow(moment.east0 + corner, moment.north0 + corner, cols);
  if (flow.IsMissing()) flow.CalmWhereMissing();
  if (moment.share > 0.0) {
    flow.Towards({moment.east1 + corner, moment.north1 + corner, cols},
                 moment.share);
    if (flow.IsMissing()) flow.CalmWhereMissing();
  }
  const FlowSlope slope = Bilinear(flow, north, east);
  at->east = gain_ * slope.value[0];
  at->east_col = gain_ * slope.east[0];
  at->east_row = gain_ * slope.north[0];
  at->north = gain_ * slope.value[1];
  at->north_col = gain_ * slope.east[1];
  at->north_row = gain_ * slope.north[1];
}

inline FlowSampler::Sample FlowSampler::operator()(const Moment& moment,
                                                   double col,
                                                   double row) const {
  const int c = Lower(col, cols_), r = Lower(row, rows_);
  const double east = col - c, north = row - r;
  const double held_east = std::min(std::max(east, 0.0), 1.0);
  const double held_north = std::min(std::max(north, 0.0), 1.0);
  felt_ = {std::min(felt_.row, r), std::max(felt_.row_end, r + 2),
           std::min(felt_.col, c), std::max(felt_.col_end, c + 2)};
  // Beyond the outer centres the outer values hold: no change across.
  Sample at;
  Interpolate(moment, static_cast<std::size_t>(r) * cols_ + c, held_north,
              held_east, &at);
  if (held_east != east) at.east_col = at.north_col = 0.0;
  if (held_north != north) at.east_row = at.north_row = 0.0;
  if (lon_per_m_[r] == 0.0) FillScale(r);
  if (lon_per_m_[r + 1] == 0.0) FillScale(r + 1);
  at.lon_per_m_row = lon_per_m_[r + 1] - lon_per_m_[r];
  at.lat_per_m_row = lat_per_m_[r + 1] - lat_per_m_[r];
  at.lon_per_m = lon_per_m_[r] + north * at.lon_per_m_row;
  at.lat_per_m = lat_per_m_[r] + north * at.lat_per_m_row;
  at.cols_per_deg = cols_per_deg_[c];
  at.rows_per_deg = rows_per_deg_[r];
  return at;
}

}  // namespace kg_compiler

#endif  // KG_COMPILER_TRAVERSAL_FLOW_H_
