#include "kg_base/raster/resample.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <vector>

namespace kg_base {
namespace {

constexpr float kOffGrid = std::numeric_limits<float>::quiet_NaN();

// Position of a target centre on a source axis: the pair of cells around it,
// the weight of the upper one, and the nearer of the two.
struct AxisSample {
  bool inside = false;
  int lower = 0;
  int upper = 0;
  int nearest = 0;
  double share = 0.0;
};

AxisSample SampleAxis(const Axis& from, double coordinate) {
  const std::optional<double> at = from.Locate(coordinate);
  if (!at) return {};
  const int size = static_cast<int>(from.centres().size());
  // Clamp: in the outer half cells there is no second centre, so the outermost
  // value applies. At the upper end the pair must exist as well.
  const double held = std::clamp(*at, 0.0, size - 1.0);
  AxisSample sample;
  sample.inside = true;
  sample.lower = std::min(static_cast<int>(held), size - 2);
  sample.upper = sample.lower + 1;
  sample.share = held - sample.lower;
  sample.nearest = sample.share >= 0.5 ? sample.upper : sample.lower;
  return sample;
}

std::vector<AxisSample> SampleAxis(const Axis& from, const Axis& to) {
  std::vector<AxisSample> samples;
  samples.reserve(to.centres().size());
  for (const double centre : to.centres()) {
    samples.push_back(SampleAxis(from, centre));
  }
  return samples;
}

float Nearest(const Grid& from, const Raster& values, const AxisSample& row,
              const AxisSample& col) {
  if (!row.inside || !col.inside) return kOffGrid;
  return values[from.Index({row.nearest, col.nearest})];
}

float Blend(const Grid& from, const Raster& values, const AxisSample& row,
            const AxisSample& col) {
  if (!row.inside || !col.inside) return kOffGrid;
  const auto value = [&](int r, int c) {
    return static_cast<double>(values[from.Index({r, c})]);
  };
  const double south = value(row.lower, col.lower) * (1.0 - col.share) +
                       value(row.lower, col.upper) * col.share;
  const double north = value(row.upper, col.lower) * (1.0 - col.share) +
                       value(row.upper, col.upper) * col.share;
  // A corner without data makes the sum NaN for any weight; then use the
  // nearest cell, which may have no data either.
  const double blend = south * (1.0 - row.share) + north * row.share;
  if (std::isnan(blend)) return values[from.Index({row.nearest, col.nearest})];
  return static_cast<float>(blend);
}

template <typename Sample>
Raster SampleAll(const Grid& from, const Raster& values, const Grid& to,
                 const Sample& sample) {
  const std::vector<AxisSample> rows =
      SampleAxis(from.lat_axis(), to.lat_axis());
  const std::vector<AxisSample> cols =
      SampleAxis(from.lon_axis(), to.lon_axis());
  Raster result;
  result.reserve(to.size());
  for (const AxisSample& row : rows) {
    for (const AxisSample& col : cols) {
      result.push_back(sample(from, values, row, col));
    }
  }
  return result;
}

}  // namespace

Raster ResampleBilinear(const Grid& from, const Raster& values,
                        const Grid& to) {
  return SampleAll(from, values, to, Blend);
}

Raster ResampleNearest(const Grid& from, const Raster& values, const Grid& to) {
  return SampleAll(from, values, to, Nearest);
}

Raster Resample(const Grid& from, const Raster& values, const Grid& to,
                Resampling how) {
  switch (how) {
    case Resampling::kBilinear:
      return ResampleBilinear(from, values, to);
    case Resampling::kNearest:
      return ResampleNearest(from, values, to);
    case Resampling::kNone:
      break;
  }
  throw std::logic_error("no resampling is named");
}

}  // namespace kg_base
