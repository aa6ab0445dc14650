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

// Smallest overlap of two cells that counts, of the smaller one's size.
constexpr double kMinOverlap = 0.01;

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

// Cells [first, end) of one axis.
struct CellSpan {
  int first = 0;
  int end = 0;
};

// For each cell of `from` the cells of `to` that overlap it.
std::vector<CellSpan> OverlappedCells(const Axis& from, const Axis& to) {
  const int to_size = static_cast<int>(to.centres().size());
  const auto overlaps = [&](double low, double high, int cell) {
    const double overlap =
        std::min(high, to.Edge(cell + 1)) - std::max(low, to.Edge(cell));
    return overlap > kMinOverlap * std::min(high - low,
                                            to.Edge(cell + 1) - to.Edge(cell));
  };
  std::vector<CellSpan> spans;
  int lowest = 0;  // Both axes ascend: no cell below it overlaps a later one.
  for (int i = 0; i < static_cast<int>(from.centres().size()); ++i) {
    const double low = from.Edge(i);
    const double high = from.Edge(i + 1);
    while (lowest < to_size && to.Edge(lowest + 1) <= low) ++lowest;
    CellSpan span{lowest, lowest};
    // The first and the last of them may overlap by too little.
    if (lowest < to_size && !overlaps(low, high, lowest)) ++span.first;
    span.end = span.first;
    while (span.end < to_size && overlaps(low, high, span.end)) ++span.end;
    spans.push_back(span);
  }
  return spans;
}

// The larger magnitude; any value replaces NaN.
float StrongerValue(float a, float b) {
  if (std::isnan(a)) return b;
  return std::abs(b) > std::abs(a) ? b : a;
}

}  // namespace

Raster ResampleBilinear(const Grid& from, const Raster& values,
                        const Grid& to) {
  return SampleAll(from, values, to, Blend);
}

Raster ResampleNearest(const Grid& from, const Raster& values, const Grid& to) {
  return SampleAll(from, values, to, Nearest);
}

Raster ResampleTouched(const Grid& from, const Raster& values, const Grid& to) {
  const auto rows = OverlappedCells(from.lat_axis(), to.lat_axis());
  const auto cols = OverlappedCells(from.lon_axis(), to.lon_axis());
  Raster result(to.size(), kOffGrid);
  for (int r = 0; r < from.rows(); ++r) {
    for (int c = 0; c < from.cols(); ++c) {
      const float value = values[from.Index({r, c})];
      if (std::isnan(value)) continue;
      for (int row = rows[r].first; row < rows[r].end; ++row) {
        for (int col = cols[c].first; col < cols[c].end; ++col) {
          float& cell = result[to.Index({row, col})];
          cell = StrongerValue(cell, value);
        }
      }
    }
  }
  return result;
}

Raster Resample(const Grid& from, const Raster& values, const Grid& to,
                Resampling how) {
  switch (how) {
    case Resampling::kBilinear:
      return ResampleBilinear(from, values, to);
    case Resampling::kNearest:
      return ResampleNearest(from, values, to);
    case Resampling::kTouched:
      return ResampleTouched(from, values, to);
    case Resampling::kNone:
      break;
  }
  throw std::logic_error("no resampling is named");
}

}  // namespace kg_base
