#include "kg_base/raster/vector_field.h"

#include <algorithm>
#include <cmath>

#include "kg_base/common/sha256.h"

namespace kg_base {
namespace {

// The four centres around a position, their bilinear weights, and the cell that
// contains the position.
struct BilinearStencil {
  std::size_t corner[4];
  double weight[4];
  std::size_t cell;
};

struct AxisWeights {
  int lower;
  int nearest;
  double share;  // Weight of the upper centre, in [0, 1].
};

// Weights along one axis; constant beyond the outer centres.
AxisWeights Weigh(double at, int size) {
  const double held = std::min(std::max(at, 0.0), size - 1.0);
  const int lower = std::min(static_cast<int>(held), size - 2);
  const double share = held - lower;
  return {lower, lower + (share >= 0.5 ? 1 : 0), share};
}

bool OnGrid(const Grid& grid, GridPoint point) {
  return point.row >= -0.5 && point.row <= grid.rows() - 0.5 &&
         point.col >= -0.5 && point.col <= grid.cols() - 0.5;
}

BilinearStencil StencilAt(const Grid& grid, GridPoint point) {
  const AxisWeights row = Weigh(point.row, grid.rows());
  const AxisWeights col = Weigh(point.col, grid.cols());
  const std::size_t cols = static_cast<std::size_t>(grid.cols());
  const std::size_t first = grid.Index({row.lower, col.lower});
  return {{first, first + 1, first + cols, first + cols + 1},
          {(1.0 - row.share) * (1.0 - col.share), (1.0 - row.share) * col.share,
           row.share * (1.0 - col.share), row.share * col.share},
          grid.Index({row.nearest, col.nearest})};
}

bool HasData(const FieldSlice& slice, std::size_t cell) {
  return !std::isnan(slice.east_mps[cell]) &&
         !std::isnan(slice.north_mps[cell]);
}

double Bilinear(const SharedRaster& values, const BilinearStencil& at) {
  return at.weight[0] * values[at.corner[0]] +
         at.weight[1] * values[at.corner[1]] +
         at.weight[2] * values[at.corner[2]] +
         at.weight[3] * values[at.corner[3]];
}

// Flow where at least one corner has no data.
std::optional<Velocity> FlowAtShore(const FieldSlice& slice,
                                    const BilinearStencil& at) {
  if (!HasData(slice, at.cell)) return std::nullopt;
  Velocity flow;
  for (int i = 0; i < 4; ++i) {
    const std::size_t corner = at.corner[i];
    if (!HasData(slice, corner)) continue;
    flow.east_mps += at.weight[i] * slice.east_mps[corner];
    flow.north_mps += at.weight[i] * slice.north_mps[corner];
  }
  return flow;
}

std::optional<Velocity> Flow(const FieldSlice& slice,
                             const BilinearStencil& at) {
  const Velocity flow{Bilinear(slice.east_mps, at),
                      Bilinear(slice.north_mps, at)};
  // NaN if any corner lacks a component, regardless of its weight.
  if (std::isnan(flow.east_mps + flow.north_mps)) return FlowAtShore(slice, at);
  return flow;
}

// The slice at or before a time between the first and the last slice (which
// must differ): first guess for even spacing, then a search if it is wrong.
std::size_t SliceBefore(const std::vector<FieldSlice>& slices, double time_s) {
  const std::size_t last = slices.size() - 2;
  const double share = (time_s - slices.front().time_s) /
                       (slices.back().time_s - slices.front().time_s);
  const std::size_t guess = std::min(
      static_cast<std::size_t>(share * static_cast<double>(last + 1)), last);
  if (slices[guess].time_s <= time_s && time_s < slices[guess + 1].time_s) {
    return guess;
  }
  const auto after = std::upper_bound(
      slices.begin(), slices.end(), time_s,
      [](double time, const FieldSlice& slice) { return time < slice.time_s; });
  return std::min(static_cast<std::size_t>(after - slices.begin()) - 1, last);
}

}  // namespace

std::optional<Velocity> VectorField::Sample(GridPoint point,
                                            double time_s) const {
  if (slices.empty() || std::isnan(time_s) || !OnGrid(grid, point)) {
    return std::nullopt;
  }
  // Before the first slice and after the last the field is constant in time.
  const BilinearStencil at = StencilAt(grid, point);
  if (time_s <= slices.front().time_s) return Flow(slices.front(), at);
  if (time_s >= slices.back().time_s) return Flow(slices.back(), at);
  const std::size_t before = SliceBefore(slices, time_s);
  const FieldSlice& a = slices[before];
  const FieldSlice& b = slices[before + 1];
  const std::optional<Velocity> begin = Flow(a, at);
  if (!begin || time_s == a.time_s) return begin;
  const std::optional<Velocity> end = Flow(b, at);
  if (!end) return std::nullopt;
  // Linear in time between two slices, both of which must have data here.
  const double share = (time_s - a.time_s) / (b.time_s - a.time_s);
  return Velocity{
      begin->east_mps + share * (end->east_mps - begin->east_mps),
      begin->north_mps + share * (end->north_mps - begin->north_mps)};
}

VectorField VectorField::Between(double begin_s, double end_s) const {
  VectorField part;
  part.grid = grid;
  part.scalars = scalars;
  for (std::size_t i = 0; i < slices.size(); ++i) {
    const bool early = i + 1 < slices.size() && slices[i + 1].time_s < begin_s;
    const bool late = i > 0 && slices[i - 1].time_s > end_s;
    if (!early && !late) part.slices.push_back(slices[i]);
  }
  return part;
}

Mask VectorField::NoData() const {
  Mask mask(grid.size(), 0);
  for (const FieldSlice& slice : slices) {
    for (std::size_t i = 0; i < mask.size(); ++i) {
      if (!HasData(slice, i)) mask[i] = 1;
    }
  }
  return mask;
}

double VectorField::MaxSpeed_mps() const {
  double most = 0.0;
  for (const FieldSlice& slice : slices) {
    for (std::size_t i = 0; i < slice.east_mps.size(); ++i) {
      if (!HasData(slice, i)) continue;
      const double east = slice.east_mps[i];
      const double north = slice.north_mps[i];
      most = std::max(most, east * east + north * north);
    }
  }
  return std::sqrt(most);
}

std::string VectorField::Hash() const {
  Hasher hasher;
  hasher.Add(grid.Hash());
  for (const FieldSlice& slice : slices) {
    hasher.Add(slice.time_s);
    hasher.Add(slice.east_mps);
    hasher.Add(slice.north_mps);
  }
  // Adds nothing if there are no scalars, so that such hashes stay unchanged.
  for (const ScalarField& scalar : scalars) {
    hasher.Add(scalar.quantity);
    for (const ScalarSlice& slice : scalar.slices) {
      hasher.Add(slice.time_s);
      hasher.Add(slice.values);
    }
  }
  return hasher.Hex();
}

}  // namespace kg_base
