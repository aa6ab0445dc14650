#include "kg_compiler/data_plane/row_kernels.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

// One function, several machines; the dynamic linker takes the best. Not under
// sanitizers, which are not ready when it does.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define KG_WIDE __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define KG_WIDE
#endif

#define KG_INLINE inline __attribute__((always_inline))

namespace kg_compiler {
namespace {

constexpr float kMost = std::numeric_limits<float>::max();
constexpr float kNoData = std::numeric_limits<float>::quiet_NaN();

inline float Positive(float x) {
  const float held = x <= kMost ? x : 0.0f;
  return held > 0.0f ? held : 0.0f;
}

// Floats >= 0 are ordered as their bits are, and the largest of integers is
// found by vectors without leave to reorder floating-point operations.
inline std::int32_t Bits(float x) {
  std::int32_t bits;
  std::memcpy(&bits, &x, sizeof(bits));
  return bits;
}

inline float OfBits(std::int32_t bits) {
  float x;
  std::memcpy(&x, &bits, sizeof(x));
  return x;
}

constexpr std::int32_t kNoneLeast = std::numeric_limits<std::int32_t>::max();

// A cell that does not count has all bits set: below every other as a candidate
// for the largest, above as one for the least but for its sign.
Extremes OfBits(std::int32_t least, std::int32_t most) {
  if (most < 0) return {};
  return {OfBits(least), OfBits(most)};
}

// One row of the stretch with its neighbours, NaN where there is no data.
struct Padded {
  float at[kTileCols + 2];
};

void Pad(const float* row, GapEnds ends, int n, Padded* padded) {
  if (!row) {
    std::fill(padded->at, padded->at + n + 2, kNoData);
    return;
  }
  const int first = ends.has_before ? -1 : 0;
  const int last = ends.has_after ? n : n - 1;
  padded->at[0] = padded->at[n + 1] = kNoData;
  for (int c = first; c <= last; ++c) {
    padded->at[c + 1] = std::abs(row[c]) <= kMost ? row[c] : kNoData;
  }
}

}  // namespace

namespace {

// F of one cell of a row, by kind of kernel.
enum class Front { kNone, kStored, kSobel, kCentral };

// The weights' quarter and half are exact.
KG_INLINE float SobelAt(const FrontRows& rows, int c) {
  const float* s = rows.south;
  const float* m = rows.middle;
  const float* t = rows.north;
  const float ks = 0.25f * rows.south_deg_per_km;
  const float km = 0.5f * rows.middle_deg_per_km;
  const float kt = 0.25f * rows.north_deg_per_km;
  const float ky = 0.25f * rows.per_km;
  const float east = ((s[c + 1] - s[c - 1]) * ks + (t[c + 1] - t[c - 1]) * kt) +
                     (m[c + 1] - m[c - 1]) * km;
  const float gx = east * rows.per_deg[c];
  const float middle = t[c] - s[c];
  const float gy =
      (((t[c - 1] - s[c - 1]) + (t[c + 1] - s[c + 1])) + (middle + middle)) *
      ky;
  return std::sqrt(gx * gx + gy * gy);
}

KG_INLINE float CentralAt(const FrontRows& rows, int c) {
  const float gx = (rows.middle[c + 1] - rows.middle[c - 1]) *
                   rows.middle_deg_per_km * rows.per_deg[c];
  const float gy = (rows.north[c] - rows.south[c]) * rows.per_km;
  return std::sqrt(gx * gx + gy * gy);
}

template <Front kind>
KG_INLINE float LayersAt(const PassRow& row, int c) {
  if constexpr (kind == Front::kNone) {
    return row.base * Positive(row.values[c]);
  }
  if constexpr (kind == Front::kStored) {
    return row.base * Positive(row.values[c]) + row.front * row.fronts[c];
  }
  const float b = row.rows.middle[c];
  const float base = row.base * (b > 0.0f ? b : 0.0f);
  if constexpr (kind == Front::kSobel) {
    return base + row.front * SobelAt(row.rows, c);
  }
  return base + row.front * CentralAt(row.rows, c);
}

enum class Soft { kNone, kInside, kSoftness };

template <Front kind, bool has_priors, Soft soft>
KG_INLINE Extremes Loop(const PassRow& in, int n, float* __restrict y) {
  const PassRow row = in;  // Its own: nothing in it changes with y.
  std::int32_t least = kNoneLeast, most = -1;
  for (int c = 0; c < n; ++c) {
    float v = LayersAt<kind>(row, c);
    if constexpr (has_priors) {
      const float p = row.priors[c];
      v += row.weight * (std::abs(p) <= kMost ? p : 0.0f);
    }
    float value = v > 0.0f ? v : 0.0f;
    if constexpr (soft == Soft::kInside) {
      value *= row.inside[c] ? row.factor : 1.0f;
    }
    if constexpr (soft == Soft::kSoftness) value *= row.softness[c];
    y[c] = value;
    const std::int32_t high = Bits(value) | -(row.state[c] != kOpen);
    const std::int32_t low = high & kNoneLeast;
    most = high > most ? high : most;
    least = low < least ? low : least;
  }
  return OfBits(least, most);
}

// The same row from a later column on.
KG_INLINE PassRow From(PassRow row, int c) {
  if (row.rows.middle) {
    row.rows.south += c;
    row.rows.middle += c;
    row.rows.north += c;
    row.rows.per_deg += c;
  }
  if (row.values) row.values += c;
  if (row.fronts) row.fronts += c;
  if (row.priors) row.priors += c;
  if (row.inside) row.inside += c;
  if (row.softness) row.softness += c;
  row.state += c;
  return row;
}

// In blocks that fill the vectors. What is left over is done as a block that
// begins earlier: cells that are made twice are the same both times.
constexpr int kBlock = 32;

template <Front kind, bool has_priors, Soft soft>
KG_INLINE Extremes Blocks(const PassRow& row, int n, float* y) {
  if (n < kBlock) return Loop<kind, has_priors, soft>(row, n, y);
  const int whole = n / kBlock * kBlock;
  const Extremes found = Loop<kind, has_priors, soft>(row, whole, y);
  if (whole == n) return found;
  const int last = n - kBlock;
  return Both(found,
              Loop<kind, has_priors, soft>(From(row, last), kBlock, y + last));
}

template <Front kind, bool has_priors>
KG_INLINE Extremes LoopBySoft(const PassRow& row, int n, float* y) {
  if (row.inside) return Blocks<kind, has_priors, Soft::kInside>(row, n, y);
  if (row.softness) return Blocks<kind, has_priors, Soft::kSoftness>(row, n, y);
  return Blocks<kind, has_priors, Soft::kNone>(row, n, y);
}

template <Front kind>
KG_INLINE Extremes PassOf(const PassRow& row, int n, float* y) {
  return row.priors ? LoopBySoft<kind, true>(row, n, y)
                    : LoopBySoft<kind, false>(row, n, y);
}

}  // namespace

KG_WIDE Extremes PassBase(const PassRow& row, int n, float* y) {
  return PassOf<Front::kNone>(row, n, y);
}
KG_WIDE Extremes PassStored(const PassRow& row, int n, float* y) {
  return PassOf<Front::kStored>(row, n, y);
}
KG_WIDE Extremes PassSobel(const PassRow& row, int n, float* y) {
  return PassOf<Front::kSobel>(row, n, y);
}
KG_WIDE Extremes PassCentral(const PassRow& row, int n, float* y) {
  return PassOf<Front::kCentral>(row, n, y);
}

KG_WIDE void Sobel(const FrontRows& in, int n, float* __restrict f) {
  const FrontRows rows = in;
  for (int c = 0; c < n; ++c) f[c] = SobelAt(rows, c);
}

KG_WIDE void Central(const FrontRows& in, int n, float* __restrict f) {
  const FrontRows rows = in;
  for (int c = 0; c < n; ++c) f[c] = CentralAt(rows, c);
}

namespace {

// Sums of slopes and of the weights they have, by column.
struct Slopes {
  float sum[kTileCols + 2];
  float weight[kTileCols + 2];
};

// What scales a difference: by column (east) or for all (north).
struct StepScales {
  const float* both;
  const float* after;
  const float* before;
  float factor;
};

}  // namespace

// `before`, `middle`, `after` are neighbours; a difference is taken over what
// is there of them.
KG_WIDE void AddSlopes(const float* __restrict before,
                       const float* __restrict middle,
                       const float* __restrict after, const StepScales& scales,
                       float weight, int n, Slopes* slopes) {
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
    // Both neighbours gone leaves middle - middle, which is no slope.
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
  Padded south, middle, north;
  Pad(rows.south, ends, n, &south);
  Pad(rows.middle, ends, n, &middle);
  Pad(rows.north, ends, n, &north);
  float before_scale[kTileCols];
  before_scale[0] = ends.has_before ? rows.per_deg_after[-1] : 0.0f;
  std::copy(rows.per_deg_after, rows.per_deg_after + n - 1, before_scale + 1);
  Slopes east = {}, north_slopes = {};
  const auto add_east = [&](const Padded& row, float deg_per_km, float weight) {
    AddSlopes(row.at, row.at + 1, row.at + 2,
              {rows.per_deg, rows.per_deg_after, before_scale, deg_per_km},
              weight, n, &east);
  };
  add_east(middle, rows.middle_deg_per_km, 2.0f);
  if (is_sobel) {
    add_east(south, rows.south_deg_per_km, 1.0f);
    add_east(north, rows.north_deg_per_km, 1.0f);
  }
  float both[kTileCols + 2], after[kTileCols + 2], before[kTileCols + 2];
  std::fill(both, both + n + 2, rows.per_km);
  std::fill(after, after + n + 2, rows.per_km_north);
  std::fill(before, before + n + 2, rows.per_km_south);
  AddSlopes(south.at, middle.at, north.at, {both, after, before, 1.0f}, 1.0f,
            n + 2, &north_slopes);
  const float* sum = north_slopes.sum + 1;
  const float* weight = north_slopes.weight + 1;
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

KG_WIDE void AddWeighted(const float* __restrict p, float weight, int n,
                         float* __restrict v) {
  for (int c = 0; c < n; ++c) {
    const float held = std::abs(p[c]) <= kMost ? p[c] : 0.0f;
    v[c] += weight * held;
  }
}

KG_WIDE void Attenuate(const unsigned char* __restrict inside, float factor,
                       int n, float* __restrict s) {
  for (int c = 0; c < n; ++c) s[c] *= inside[c] ? factor : 1.0f;
}

KG_WIDE void AttenuateToLeast(const unsigned char* __restrict inside,
                              float factor, int n, float* __restrict s) {
  for (int c = 0; c < n; ++c) {
    const float own = inside[c] ? factor : 1.0f;
    s[c] = own < s[c] ? own : s[c];
  }
}

KG_WIDE Extremes OpenExtremes(const float* __restrict y,
                              const unsigned char* __restrict state, int n) {
  std::int32_t least = kNoneLeast, most = -1;
  for (int c = 0; c < n; ++c) {
    const std::int32_t bits = Bits(y[c]);
    const std::int32_t high = bits | -(state[c] != kOpen);
    const std::int32_t low = high & kNoneLeast;
    most = high > most ? high : most;
    least = low < least ? low : least;
  }
  return OfBits(least, most);
}

namespace {

KG_INLINE void FuseLoop(const float* __restrict y,
                        const unsigned char* __restrict state,
                        const RowScale& n, int count, float* __restrict u) {
  const float scale = n.scale, low = n.low, range = n.range, after = n.after;
  for (int c = 0; c < count; ++c) {
    const float x = (scale * y[c] - low) / range;
    const float positive = x > 0.0f ? x : 0.0f;
    const float held = after * (positive < 1.0f ? positive : 1.0f);
    u[c] = state[c] == kOpen ? held : 0.0f;
  }
}

}  // namespace

KG_WIDE void Normalise(const float* __restrict y, const RowScale& n, int count,
                       float* __restrict u) {
  const float scale = n.scale, low = n.low, range = n.range, after = n.after;
  if (!(range > 0.0f)) {
    std::fill(u, u + count, 0.0f);
    return;
  }
  for (int c = 0; c < count; ++c) {
    const float x = (scale * y[c] - low) / range;
    const float held = x > 0.0f ? x : 0.0f;
    u[c] = after * (held < 1.0f ? held : 1.0f);
  }
}

KG_WIDE void NormaliseOpen(const float* y, const unsigned char* state,
                           const RowScale& n, int count, float* u) {
  if (!(n.range > 0.0f)) {
    std::fill(u, u + count, 0.0f);
    return;
  }
  const int whole = count / kBlock * kBlock;
  const int first = count < kBlock ? 0 : count - kBlock;
  FuseLoop(y, state, n, whole, u);
  if (whole == count) return;
  FuseLoop(y + first, state + first, n, count - first, u + first);
}

KG_WIDE bool AllFinite(const float* __restrict values, int n) {
  std::int32_t bad = 0;
  for (int c = 0; c < n; ++c) bad |= std::abs(values[c]) <= kMost ? 0 : 1;
  return bad == 0;
}

KG_WIDE Magnitudes MagnitudesOf(const float* __restrict values, int n) {
  std::int32_t most = 0, largest = 0;
  for (int c = 0; c < n; ++c) {
    const float held = std::abs(values[c]) <= kMost ? values[c] : 0.0f;
    const std::int32_t bits = Bits(held > 0.0f ? held : 0.0f);
    const std::int32_t magnitude = Bits(std::abs(held));
    most = bits > most ? bits : most;
    largest = magnitude > largest ? magnitude : largest;
  }
  return {OfBits(most), OfBits(largest)};
}

KG_WIDE float MostOf(const float* __restrict values, int n) {
  std::int32_t most = 0;
  for (int c = 0; c < n; ++c) {
    const std::int32_t bits = Bits(Positive(values[c]));
    most = bits > most ? bits : most;
  }
  return OfBits(most);
}

KG_WIDE float MostOpen(const float* __restrict values,
                       const unsigned char* __restrict state, int n) {
  std::int32_t most = 0;
  for (int c = 0; c < n; ++c) {
    const std::int32_t bits = Bits(Positive(values[c])) & -(state[c] == kOpen);
    most = bits > most ? bits : most;
  }
  return OfBits(most);
}

void Stream(const float* from, int n, float* to) {
#if defined(__SSE2__)
  int c = 0;
  for (; c + 4 <= n; c += 4) _mm_stream_ps(to + c, _mm_loadu_ps(from + c));
  for (; c < n; ++c) to[c] = from[c];
#else
  std::memcpy(to, from, static_cast<std::size_t>(n) * sizeof(float));
#endif
}

void StreamEnd() {
#if defined(__SSE2__)
  _mm_sfence();
#endif
}

}  // namespace kg_compiler
