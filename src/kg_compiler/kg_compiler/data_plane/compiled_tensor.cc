#include "kg_compiler/data_plane/compiled_tensor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>
#include <vector>

namespace kg_compiler {
namespace {

constexpr double kTopPercentile = 0.98;

template <typename Visit>
void ForEachOpen(const BlendedField& field, const Visit& visit) {
  for (int r = 0; r < field.tiling.rows; ++r) {
    const float* y = field.masked.Row(r);
    const unsigned char* state = field.state.Row(r);
    for (int c = 0; c < field.tiling.cols; ++c) {
      if (state[c] != kOpen) continue;
      std::uint32_t bits;
      std::memcpy(&bits, &y[c], sizeof(bits));
      visit(bits);
    }
  }
}

// First entry at which the cumulative count reaches `rank`; the counts before
// it are subtracted from `rank`.
std::uint32_t Select(const std::vector<std::size_t>& counts,
                     std::size_t* rank) {
  std::uint32_t i = 0;
  while (counts[i] < *rank) *rank -= counts[i++];
  return i;
}

// Nearest-rank percentile by two histogram passes over the upper and then the
// lower 16 bits: floats >= 0 have the order of their bit patterns.
float Percentile(const BlendedField& field) {
  std::vector<std::size_t> counts(1 << 16, 0);
  std::size_t all = 0;
  ForEachOpen(field, [&](std::uint32_t bits) {
    ++counts[bits >> 16];
    ++all;
  });
  std::size_t rank = static_cast<std::size_t>(
      std::ceil(kTopPercentile * static_cast<double>(all)));
  const std::uint32_t upper = Select(counts, &rank);
  std::fill(counts.begin(), counts.end(), 0);
  ForEachOpen(field, [&](std::uint32_t bits) {
    if (bits >> 16 == upper) ++counts[bits & 0xffff];
  });
  const std::uint32_t bits = upper << 16 | Select(counts, &rank);
  float value;
  std::memcpy(&value, &bits, sizeof(value));
  return value;
}

}  // namespace

RowScale FitScale(const BlendedField& field, const kg_mission::Policy& policy,
                  float before, const HorizonScale* horizon) {
  RowScale n;
  n.scale = before;
  if (horizon) {
    n.low = static_cast<float>(horizon->low / field.unit);
    n.range = static_cast<float>(horizon->range / field.unit);
    return n;
  }
  const ValueExtremes all = field.All();
  if (!(all.max >= all.min)) return n;  // No cell counted.
  const float min_value = before * all.min, max_value = before * all.max;
  n.range =
      max_value;  // N divides by the maximum, unless a policy says otherwise.
  const bool is_minmax =
      field.is_literal ||
      policy.normalisation == kg_mission::Normalisation::kMinMax;
  if (is_minmax && max_value > min_value) {
    n.low = min_value;
    n.range = max_value - min_value;
  } else if (!is_minmax &&
             policy.normalisation == kg_mission::Normalisation::kPercentile) {
    const float range = before * Percentile(field);
    if (range > 0.0f) n.range = range;
  }
  return n;
}

CompiledTensor::CompiledTensor(std::shared_ptr<const BlendedField> field,
                               const RowScale& scale, double confidence)
    : field_(std::move(field)),
      scale_(scale),
      unweighted_(scale),
      doubt_(static_cast<float>(1.0 - confidence)) {
  unweighted_.after = 1.0f;
}

void CompiledTensor::Fuse(const float* y, const unsigned char* state, int n,
                          float* u) const {
  if (!field_->is_literal) {
    NormaliseOpen(y, state, scale_, n, u);
    return;
  }
  Normalise(y, scale_, n, u);
  for (int c = 0; c < n; ++c) u[c] = state[c] == kLand ? 0.0f : u[c];
}

void CompiledTensor::GetRow(Layer layer, kg_base::Cell first, int n,
                            float* values) const {
  const float* y = field_->masked.Row(first.row) + first.col;
  const unsigned char* state = field_->state.Row(first.row) + first.col;
  switch (layer) {
    // Also in forbidden cells: the value of a place without masks and w_t.
    case Layer::kReward:
      Normalise(y, unweighted_, n, values);
      for (int c = 0; c < n; ++c) {
        values[c] = state[c] == kLand ? 0.0f : values[c];
      }
      return;
    case Layer::kUncertainty:
      std::fill(values, values + n, doubt_);
      return;
    case Layer::kPolicy:
      PriorsOfRow(field_->recipe, first, n, values);
      return;
    case Layer::kAttenuation:
      if (!SoftnessOfRow(field_->recipe, first, n, values)) {
        std::fill(values, values + n, 1.0f);
      }
      return;
    case Layer::kFeasibility:
      for (int c = 0; c < n; ++c) {
        values[c] = state[c] == kLand ? std::numeric_limits<float>::quiet_NaN()
                    : state[c] == kOpen ? 1.0f
                                        : 0.0f;
      }
      return;
    case Layer::kFused:
      Fuse(y, state, n, values);
      return;
  }
}

float CompiledTensor::At(Layer layer, std::size_t cell) const {
  const std::size_t cols = static_cast<std::size_t>(field_->tiling.cols);
  float value = 0.0f;
  GetRow(layer, {static_cast<int>(cell / cols), static_cast<int>(cell % cols)},
         1, &value);
  return value;
}

kg_base::Raster CompiledTensor::Get(Layer layer) const {
  const TileLayout& tiling = field_->tiling;
  kg_base::Raster values;
  values.reserve(static_cast<std::size_t>(tiling.rows) * tiling.cols);
  std::array<float, kTileCols> part;
  for (int r = 0; r < tiling.rows; ++r) {
    for (int c = 0; c < tiling.cols; c += kTileCols) {
      const int n = std::min(kTileCols, tiling.cols - c);
      GetRow(layer, {r, c}, n, part.data());
      values.insert(values.end(), part.begin(), part.begin() + n);
    }
  }
  return values;
}

}  // namespace kg_compiler
