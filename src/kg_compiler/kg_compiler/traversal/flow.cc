#include "kg_compiler/traversal/flow.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kg_core/geo/geodesy.h"

namespace kg_compiler {
namespace {

std::vector<double> PerDegree(const std::vector<double>& centres) {
  std::vector<double> per_deg;
  per_deg.reserve(centres.size());
  for (std::size_t i = 0; i + 1 < centres.size(); ++i) {
    per_deg.push_back(1.0 / (centres[i + 1] - centres[i]));
  }
  return per_deg;
}

// One component at the four centres around a position.
struct Corners {
  double sw, se, nw, ne;

  Corners(const float* values, std::size_t cols)
      : sw(values[0]), se(values[1]), nw(values[cols]), ne(values[cols + 1]) {}
  void Towards(const float* later, std::size_t cols, double share) {
    sw += share * (later[0] - sw);
    se += share * (later[1] - se);
    nw += share * (later[cols] - nw);
    ne += share * (later[cols + 1] - ne);
  }
  void CalmWhereMissing() {
    for (double* value : {&sw, &se, &nw, &ne}) {
      if (std::isnan(*value)) *value = 0.0;
    }
  }
  bool Missing() const { return std::isnan(sw + se + nw + ne); }
};

struct Slope {
  double value, east, north;
};
Slope Bilinear(const Corners& c, double north, double east) {
  const double south_rise = c.se - c.sw, north_rise = c.ne - c.nw;
  const double s = c.sw + east * south_rise;
  const double n = c.nw + east * north_rise;
  return {s + north * (n - s), south_rise + north * (north_rise - south_rise),
          n - s};
}

}  // namespace

Flow::Flow(const Voyage& voyage)
    : field_(*voyage.world.field),
      gain_(voyage.motion.boost_gain),
      epoch_s_(voyage.departure.time_s),
      rows_(field_.grid.rows()),
      cols_(field_.grid.cols()),
      cols_per_deg_(PerDegree(field_.grid.lon_deg())),
      rows_per_deg_(PerDegree(field_.grid.lat_deg())),
      lon_per_m_(rows_, 0.0),
      lat_per_m_(rows_, 0.0) {
  for (const kg_core::FieldSlice& slice : field_.slices) {
    slice_s_.push_back(slice.time_s - epoch_s_);
  }
}

Flow::Moment Flow::At(double time_s) const {
  const auto after = std::upper_bound(slice_s_.begin(), slice_s_.end(), time_s);
  const std::size_t k = after - slice_s_.begin();
  const std::size_t a = k == 0 ? 0 : k - 1;
  const std::size_t b = std::min(k, slice_s_.size() - 1);
  const double span_s = slice_s_[b] - slice_s_[a];
  const kg_core::FieldSlice& first = field_.slices[a];
  const kg_core::FieldSlice& second = field_.slices[b];
  return {first.east_mps.data(), first.north_mps.data(), second.east_mps.data(),
          second.north_mps.data(),
          span_s > 0.0 ? (time_s - slice_s_[a]) / span_s : 0.0};
}

double Flow::NextSlice_s(double time_s) const {
  const auto after = std::upper_bound(slice_s_.begin(), slice_s_.end(), time_s);
  return after == slice_s_.end() ? std::numeric_limits<double>::infinity()
                                 : *after;
}

void Flow::FillScale(int row) const {
  const kg_core::DegreesPerMetre scale =
      kg_core::LocalScale(field_.grid.lat_deg()[row]);
  lon_per_m_[row] = scale.lon_deg;
  lat_per_m_[row] = scale.lat_deg;
}

kg_core::LonLat Flow::Scale(double row) const {
  const int r = Lower(row, rows_);
  if (lon_per_m_[r] == 0.0) FillScale(r);
  if (lon_per_m_[r + 1] == 0.0) FillScale(r + 1);
  const double n = row - r;
  return {lon_per_m_[r] + n * (lon_per_m_[r + 1] - lon_per_m_[r]),
          lat_per_m_[r] + n * (lat_per_m_[r + 1] - lat_per_m_[r])};
}

void Flow::Interpolate(const Moment& moment, std::size_t corner, double north,
                       double east, Sample* at) const {
  const std::size_t cols = static_cast<std::size_t>(cols_);
  Corners u(moment.east0 + corner, cols), v(moment.north0 + corner, cols);
  if (u.Missing() || v.Missing()) {
    u.CalmWhereMissing();
    v.CalmWhereMissing();
  }
  if (moment.share > 0.0) {
    u.Towards(moment.east1 + corner, cols, moment.share);
    v.Towards(moment.north1 + corner, cols, moment.share);
    if (u.Missing() || v.Missing()) {
      u.CalmWhereMissing();
      v.CalmWhereMissing();
    }
  }
  const Slope e = Bilinear(u, north, east), n = Bilinear(v, north, east);
  at->east = gain_ * e.value;
  at->east_col = gain_ * e.east;
  at->east_row = gain_ * e.north;
  at->north = gain_ * n.value;
  at->north_col = gain_ * n.east;
  at->north_row = gain_ * n.north;
}

Flow::Sample Flow::operator()(const Moment& moment, double col,
                              double row) const {
  const int c = Lower(col, cols_), r = Lower(row, rows_);
  const double east = col - c, north = row - r;
  const double held_east = std::min(std::max(east, 0.0), 1.0);
  const double held_north = std::min(std::max(north, 0.0), 1.0);
  felt_ = {std::min(felt_.row, r), std::max(felt_.row_end, r + 2),
           std::min(felt_.col, c), std::max(felt_.col_end, c + 2)};
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
