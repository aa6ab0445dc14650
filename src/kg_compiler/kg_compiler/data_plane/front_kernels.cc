#include "kg_compiler/data_plane/front_kernels.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kg_compiler/data_plane/front_at.h"
#include "kg_compiler/data_plane/wide.h"

namespace kg_compiler {
namespace {

constexpr float kNoData = std::numeric_limits<float>::quiet_NaN();

// One row of the segment plus one column on either side; NaN = no data.
struct PaddedRow {
  float at[kTileCols + 2];
};

void Pad(const float* row, GapEnds ends, int n, PaddedRow* padded) {
  if (!row) {
    std::fill(padded->at, padded->at + n + 2, kNoData);
    return;
  }
  const int first = ends.has_before ? -1 : 0;
  const int last = ends.has_after ? n : n - 1;
  padded->at[0] = padded->at[n + 1] = kNoData;
  for (int c = first; c <= last; ++c) {
    padded->at[c + 1] = std::abs(row[c]) <= kMaxFloat ? row[c] : kNoData;
  }
}

}  // namespace

KG_WIDE void Sobel(const FrontRows& in, int n, float* __restrict f) {
  const FrontRows rows = in;
  for (int c = 0; c < n; ++c) f[c] = SobelAt(rows, c);
}

KG_WIDE void Central(const FrontRows& in, int n, float* __restrict f) {
  const FrontRows rows = in;
  for (int c = 0; c < n; ++c) f[c] = CentralAt(rows, c);
}

namespace {

// Weighted sums of slopes and sums of their weights, by column.
struct SlopeSums {
  float sum[kTileCols + 2];
  float weight[kTileCols + 2];
};

// Inverse step lengths of differences: per column (east) or constant (north).
struct StepScales {
  const float* both;
  const float* after;
  const float* before;
  float factor;
};

}  // namespace

// Adds weighted slopes at `middle`; differences use those of the neighbours
// `before` and `after` that have data.
KG_WIDE void AddSlopes(const float* __restrict before,
                       const float* __restrict middle,
                       const float* __restrict after, const StepScales& scales,
                       float weight, int n, SlopeSums* slopes) {
  float* __restrict sum = slopes->sum;
  float* __restrict weights = slopes->weight;
  const float* __restrict both_scale = scales.both;
  const float* __restrict after_scale = scales.after;
  const float* __restrict before_scale = scales.before;
  const float factor = scales.factor;
  for (int c = 0; c < n; ++c) {
    const float b = before[c], m = middle[c], a = after[c];
    const float high = a == a ? a : m;
    const float low = b == b ? b : m;
    const float with_before = a == a ? both_scale[c] : before_scale[c];
    const float scale = b == b ? with_before : after_scale[c];
    const float slope = (high - low) * scale * factor;
    // Without both neighbours the slope would be middle - middle: weight 0.
    const float sides = (a == a ? 1.0f : 0.0f) + (b == b ? 1.0f : 0.0f);
    const float known = slope == slope ? sides : 0.0f;
    sum[c] += known > 0.0f ? weight * slope : 0.0f;
    weights[c] += known > 0.0f ? weight : 0.0f;
  }
}

namespace {

float Mean(float sum, float weight) {
  return weight > 0.0f ? sum / weight : 0.0f;
}

}  // namespace

void FrontWithGaps(const FrontRows& rows, bool is_sobel, GapEnds ends, int n,
                   float* f) {
  // Step 1: the three rows with NaN for gaps and beyond the grid.
  PaddedRow south, middle, north;
  Pad(rows.south, ends, n, &south);
  Pad(rows.middle, ends, n, &middle);
  Pad(rows.north, ends, n, &north);
  float before_scale[kTileCols];
  before_scale[0] = ends.has_before ? rows.per_deg_after[-1] : 0.0f;
  std::copy(rows.per_deg_after, rows.per_deg_after + n - 1, before_scale + 1);
  // Step 2: eastward slopes of the middle row, for Sobel of all three with
  // weights 1 2 1, of those that have neighbours.
  SlopeSums east = {}, north_slopes = {};
  const auto add_east = [&](const PaddedRow& row, float deg_per_km,
                            float weight) {
    AddSlopes(row.at, row.at + 1, row.at + 2,
              {rows.per_deg, rows.per_deg_after, before_scale, deg_per_km},
              weight, n, &east);
  };
  add_east(middle, rows.middle_deg_per_km, 2.0f);
  if (is_sobel) {
    add_east(south, rows.south_deg_per_km, 1.0f);
    add_east(north, rows.north_deg_per_km, 1.0f);
  }
  // Step 3: northward slopes of all columns, one more on either side.
  float both[kTileCols + 2], after[kTileCols + 2], before[kTileCols + 2];
  std::fill(both, both + n + 2, rows.per_km);
  std::fill(after, after + n + 2, rows.per_km_north);
  std::fill(before, before + n + 2, rows.per_km_south);
  AddSlopes(south.at, middle.at, north.at, {both, after, before, 1.0f}, 1.0f,
            n + 2, &north_slopes);
  const float* sum = north_slopes.sum + 1;
  const float* weight = north_slopes.weight + 1;
  // Step 4: weighted means of both components, and the norm of the gradient.
  const float side = is_sobel ? 1.0f : 0.0f;
  for (int c = 0; c < n; ++c) {
    const float gx = Mean(east.sum[c], east.weight[c]);
    const float gy =
        Mean(2.0f * sum[c] + side * (sum[c - 1] + sum[c + 1]),
             2.0f * weight[c] + side * (weight[c - 1] + weight[c + 1]));
    const float b = middle.at[c + 1];
    f[c] = b == b ? std::sqrt(gx * gx + gy * gy) : 0.0f;
  }
}

}  // namespace kg_compiler
