#include "kg_base/raster/scalar_field.h"

#include <algorithm>
#include <cmath>

namespace kg_base {
namespace {

// The centre below a position along one axis, and the weight of the one above.
// Constant beyond the outer centres.
struct AxisShare {
  AxisShare(double at, int size)
      : lower(std::min(static_cast<int>(std::clamp(at, 0.0, size - 1.0)),
                       size - 2)),
        share(std::clamp(at, 0.0, size - 1.0) - lower) {}
  int lower;
  double share;
};

double Interpolate(const SharedRaster& values, const Grid& grid,
                   GridPoint point) {
  const AxisShare row(point.row, grid.rows()), col(point.col, grid.cols());
  double sum = 0.0, known = 0.0;
  for (const int up : {0, 1}) {
    for (const int right : {0, 1}) {
      const double weight = (up == 1 ? row.share : 1.0 - row.share) *
                            (right == 1 ? col.share : 1.0 - col.share);
      const float value =
          values[grid.Index({row.lower + up, col.lower + right})];
      // The weight of a corner without data is distributed over the others.
      if (std::isnan(value)) continue;
      sum += weight * value;
      known += weight;
    }
  }
  return known > 0.0 ? sum / known : 0.0;
}

}  // namespace

double ScalarField::Sample(const Grid& grid, GridPoint point,
                           double time_s) const {
  const bool on_grid = point.row >= -0.5 && point.row <= grid.rows() - 0.5 &&
                       point.col >= -0.5 && point.col <= grid.cols() - 0.5;
  if (slices.empty() || !on_grid) return 0.0;
  const auto after =
      std::upper_bound(slices.begin(), slices.end(), time_s,
                       [](double time, const ScalarSlice& slice) {
                         return time < slice.time_s;
                       });
  if (after == slices.begin()) {
    return Interpolate(slices.front().values, grid, point);
  }
  const ScalarSlice& before = *std::prev(after);
  const double begin = Interpolate(before.values, grid, point);
  if (after == slices.end()) return begin;
  const double share =
      (time_s - before.time_s) / (after->time_s - before.time_s);
  return begin + share * (Interpolate(after->values, grid, point) - begin);
}

}  // namespace kg_base
