#include "kg_core/raster/grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "kg_core/base/sha256.h"
#include "kg_core/geo/geodesy.h"

namespace kg_core {
namespace {

constexpr float kNoData = std::numeric_limits<float>::quiet_NaN();

// The cell whose centre is nearest in cell units, on an axis of `size` cells.
int NearestCell(double at, int size) {
  const int cell = static_cast<int>(std::floor(at + 0.5));
  return std::clamp(cell, 0, size - 1);
}

bool AlmostEqualAxes(const Axis& a, const Axis& b, double tolerance) {
  if (a.centres().size() != b.centres().size()) return false;
  for (std::size_t i = 0; i < a.centres().size(); ++i) {
    const double allowed = tolerance * a.Spacing(static_cast<double>(i));
    if (!(std::abs(a.centres()[i] - b.centres()[i]) <= allowed)) return false;
  }
  return true;
}

// Where a target centre lies on a source axis: the pair of cells around it, the
// share of the upper one, and the nearer of the two.
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
  const double held = std::clamp(*at, 0.0, size - 1.0);
  AxisSample sample;
  sample.inside = true;
  sample.lower = std::min(static_cast<int>(held), size - 2);
  sample.upper = sample.lower + 1;
  sample.share = held - sample.lower;
  sample.nearest = NearestCell(held, size);
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

float Blend(const Grid& from, const Raster& values, const AxisSample& row,
            const AxisSample& col) {
  if (!row.inside || !col.inside) return kNoData;
  const auto value = [&](int r, int c) {
    return static_cast<double>(values[from.Index({r, c})]);
  };
  const double south = value(row.lower, col.lower) * (1.0 - col.share) +
                       value(row.lower, col.upper) * col.share;
  const double north = value(row.upper, col.lower) * (1.0 - col.share) +
                       value(row.upper, col.upper) * col.share;
  const double blend = south * (1.0 - row.share) + north * row.share;
  if (std::isnan(blend)) return values[from.Index({row.nearest, col.nearest})];
  return static_cast<float>(blend);
}

}  // namespace

Grid::Grid(std::vector<double> lon_deg, std::vector<double> lat_deg)
    : lon_(std::move(lon_deg)), lat_(std::move(lat_deg)) {}

LonLat Grid::Position(GridPoint point) const {
  return {lon_.At(point.col), lat_.At(point.row)};
}

std::optional<Cell> Grid::CellAt(LonLat position) const {
  const std::optional<GridPoint> at = Locate(position);
  if (!at) return std::nullopt;
  return Cell{NearestCell(at->row, rows()), NearestCell(at->col, cols())};
}

double Grid::west_deg() const { return lon_.low(); }
double Grid::east_deg() const { return lon_.high(); }
double Grid::south_deg() const { return lat_.low(); }
double Grid::north_deg() const { return lat_.high(); }

LonLat Grid::Middle() const {
  return {0.5 * (west_deg() + east_deg()), 0.5 * (south_deg() + north_deg())};
}

double Grid::MetresPerRow(double row) const {
  return lat_.Spacing(row) / LocalScale(lat_.At(row)).lat_deg;
}

double Grid::MetresPerCol(double row, double col) const {
  return lon_.Spacing(col) / LocalScale(lat_.At(row)).lon_deg;
}

std::string Grid::Hash() const {
  Hasher hasher;
  hasher.Add("lon_deg");
  for (const double lon : lon_deg()) hasher.Add(lon);
  hasher.Add("lat_deg");
  for (const double lat : lat_deg()) hasher.Add(lat);
  return hasher.Hex();
}

bool Grid::AlmostEquals(const Grid& other, double tolerance) const {
  return AlmostEqualAxes(lon_, other.lon_, tolerance) &&
         AlmostEqualAxes(lat_, other.lat_, tolerance);
}

bool operator==(const Grid& a, const Grid& b) {
  return a.lon_deg() == b.lon_deg() && a.lat_deg() == b.lat_deg();
}

Raster ResampleBilinear(const Grid& from, const Raster& values,
                        const Grid& to) {
  const std::vector<AxisSample> rows =
      SampleAxis(from.lat_axis(), to.lat_axis());
  const std::vector<AxisSample> cols =
      SampleAxis(from.lon_axis(), to.lon_axis());
  Raster result;
  result.reserve(to.size());
  for (const AxisSample& row : rows) {
    for (const AxisSample& col : cols) {
      result.push_back(Blend(from, values, row, col));
    }
  }
  return result;
}

}  // namespace kg_core
