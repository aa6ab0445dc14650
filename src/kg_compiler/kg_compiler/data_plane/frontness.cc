#include "kg_compiler/data_plane/frontness.h"

#include <cmath>
#include <limits>

#include "kg_base/common/units.h"
#include "kg_base/geo/geodesy.h"

namespace kg_compiler {
namespace {

constexpr float kNoFront = std::numeric_limits<float>::quiet_NaN();

// Distance from each row to the next [km], and scale of a row [km/deg].
struct GridScales {
  std::vector<double> row_step_km;
  std::vector<double> km_per_lon_deg;
};

GridScales Measure(const kg_base::Grid& grid) {
  GridScales scales;
  const std::vector<double>& lat_deg = grid.lat_deg();
  for (std::size_t r = 0; r < lat_deg.size(); ++r) {
    scales.km_per_lon_deg.push_back(
        1.0 / kg_base::LocalScale(lat_deg[r]).lon_deg / kg_base::kMetresPerKm);
    if (r == 0) continue;
    const double middle_deg = 0.5 * (lat_deg[r] + lat_deg[r - 1]);
    const double deg = lat_deg[r] - lat_deg[r - 1];
    scales.row_step_km.push_back(deg / kg_base::LocalScale(middle_deg).lat_deg /
                                 kg_base::kMetresPerKm);
  }
  return scales;
}

// The slope at `mid` between a neighbour `before` and one `after` it.
struct NeighbourDifference {
  double before, mid, after;   // Values; non-finite = no data.
  double before_km, after_km;  // Distances to the middle.
};

// False where no difference can be formed.
bool Slope(const NeighbourDifference& d, double* slope) {
  const bool has_before = std::isfinite(d.before);
  const bool has_after = std::isfinite(d.after);
  const bool has_mid = std::isfinite(d.mid);
  if (has_before && has_after) {
    *slope = (d.after - d.before) / (d.before_km + d.after_km);
  } else if (has_after && has_mid) {
    *slope = (d.after - d.mid) / d.after_km;
  } else if (has_before && has_mid) {
    *slope = (d.mid - d.before) / d.before_km;
  } else {
    return false;
  }
  return true;
}

class GradientField {
 public:
  GradientField(const kg_base::Grid& grid, const kg_base::Raster& values,
                kg_mission::FrontOperator op)
      : grid_(grid),
        values_(values),
        scales_(Measure(grid)),
        reach_(op == kg_mission::FrontOperator::kSobel ? 1 : 0) {}

  float At(int r, int c) const {
    if (!std::isfinite(Value(r, c))) return kNoFront;
    double east = 0.0, north = 0.0, east_weight = 0.0, north_weight = 0.0;
    for (int k = -reach_; k <= reach_; ++k) {
      const double weight = k == 0 ? 2.0 : 1.0;
      double slope = 0.0;
      if (Eastward(r + k, c, &slope)) {
        east += weight * slope;
        east_weight += weight;
      }
      if (Northward(r, c + k, &slope)) {
        north += weight * slope;
        north_weight += weight;
      }
    }
    if (east_weight > 0.0) east /= east_weight;
    if (north_weight > 0.0) north /= north_weight;
    return static_cast<float>(std::sqrt(east * east + north * north));
  }

 private:
  double Value(int r, int c) const {
    return grid_.Contains({r, c}) ? values_[grid_.Index({r, c})] : kNoFront;
  }
  bool Eastward(int r, int c, double* slope) const {
    if (r < 0 || r >= grid_.rows()) return false;
    const std::vector<double>& lon = grid_.lon_deg();
    const double scale = scales_.km_per_lon_deg[r];
    const double before = c > 0 ? (lon[c] - lon[c - 1]) * scale : 0.0;
    const double after =
        c + 1 < grid_.cols() ? (lon[c + 1] - lon[c]) * scale : 0.0;
    return Slope({Value(r, c - 1), Value(r, c), Value(r, c + 1), before, after},
                 slope);
  }
  bool Northward(int r, int c, double* slope) const {
    if (c < 0 || c >= grid_.cols()) return false;
    const std::vector<double>& step = scales_.row_step_km;
    const double before = r > 0 ? step[r - 1] : 0.0;
    const double after = r + 1 < grid_.rows() ? step[r] : 0.0;
    return Slope({Value(r - 1, c), Value(r, c), Value(r + 1, c), before, after},
                 slope);
  }

  const kg_base::Grid& grid_;
  const kg_base::Raster& values_;
  GridScales scales_;
  int reach_;  // Rows and columns beside the cell's own.
};

}  // namespace

kg_base::Raster GradientPerKm(const kg_base::Grid& grid,
                              const kg_base::Raster& values,
                              kg_mission::FrontOperator op) {
  const GradientField gradient(grid, values, op);
  kg_base::Raster result;
  result.reserve(values.size());
  for (int r = 0; r < grid.rows(); ++r) {
    for (int c = 0; c < grid.cols(); ++c) result.push_back(gradient.At(r, c));
  }
  return result;
}

}  // namespace kg_compiler
