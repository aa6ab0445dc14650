#include "kg_compiler/traversal/flow.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kg_base/geo/geodesy.h"

namespace kg_compiler {
namespace {

std::vector<double> Widths(const std::vector<double>& centres) {
  std::vector<double> widths(centres.size() - 1);
  for (std::size_t i = 0; i < widths.size(); ++i) {
    widths[i] = centres[i + 1] - centres[i];
  }
  return widths;
}

std::vector<double> Inverse(std::vector<double> values) {
  for (double& value : values) value = 1.0 / value;
  return values;
}

}  // namespace

FlowSampler::FlowSampler(const VoyageRequest& voyage)
    : field_(*voyage.world.field),
      gain_(voyage.motion.boost_gain),
      epoch_s_(voyage.departure.time_s),
      rows_(field_.grid.rows()),
      cols_(field_.grid.cols()),
      deg_per_col_(Widths(field_.grid.lon_deg())),
      deg_per_row_(Widths(field_.grid.lat_deg())),
      cols_per_deg_(Inverse(deg_per_col_)),
      rows_per_deg_(Inverse(deg_per_row_)),
      lon_per_m_(rows_, 0.0),
      lat_per_m_(rows_, 0.0) {
  for (const kg_base::FieldSlice& slice : field_.slices) {
    slice_s_.push_back(slice.time_s - epoch_s_);
  }
}

FlowSampler::Moment FlowSampler::At(double time_s) const {
  const auto after = std::upper_bound(slice_s_.begin(), slice_s_.end(), time_s);
  const std::size_t k = after - slice_s_.begin();
  const std::size_t a = k == 0 ? 0 : k - 1;
  const std::size_t b = std::min(k, slice_s_.size() - 1);
  const double span_s = slice_s_[b] - slice_s_[a];
  const kg_base::FieldSlice& first = field_.slices[a];
  const kg_base::FieldSlice& second = field_.slices[b];
  return {first.east_mps.data(), first.north_mps.data(), second.east_mps.data(),
          second.north_mps.data(),
          span_s > 0.0 ? (time_s - slice_s_[a]) / span_s : 0.0};
}

double FlowSampler::NextSlice_s(double time_s) const {
  const auto after = std::upper_bound(slice_s_.begin(), slice_s_.end(), time_s);
  return after == slice_s_.end() ? std::numeric_limits<double>::infinity()
                                 : *after;
}

void FlowSampler::FillScale(int row) const {
  const kg_base::DegreesPerMetre scale =
      kg_base::LocalScale(field_.grid.lat_deg()[row]);
  lon_per_m_[row] = scale.lon_deg;
  lat_per_m_[row] = scale.lat_deg;
}

kg_base::LonLat FlowSampler::Scale(double row) const {
  const int r = Lower(row, rows_);
  if (lon_per_m_[r] == 0.0) FillScale(r);
  if (lon_per_m_[r + 1] == 0.0) FillScale(r + 1);
  const double n = row - r;
  return {lon_per_m_[r] + n * (lon_per_m_[r + 1] - lon_per_m_[r]),
          lat_per_m_[r] + n * (lat_per_m_[r + 1] - lat_per_m_[r])};
}

}  // namespace kg_compiler
