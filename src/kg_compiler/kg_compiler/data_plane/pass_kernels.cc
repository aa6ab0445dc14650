#include "kg_compiler/data_plane/pass_kernels.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "kg_compiler/data_plane/front_at.h"
#include "kg_compiler/data_plane/wide.h"

namespace kg_compiler {
namespace {

// Source of F in a kernel.
enum class Front { kNone, kStored, kSobel, kCentral };

template <Front kind>
KG_INLINE float LayersAt(const PassRow& row, int c) {
  if constexpr (kind == Front::kNone) {
    return row.base * Positive(row.values[c]);
  }
  if constexpr (kind == Front::kStored) {
    return row.base * Positive(row.values[c]) + row.front * row.fronts[c];
  }
  const float b = row.rows.middle[c];
  const float base = row.base * AtLeast0(b);
  if constexpr (kind == Front::kSobel) {
    return base + row.front * SobelAt(row.rows, c);
  }
  return base + row.front * CentralAt(row.rows, c);
}

enum class Soft { kNone, kInside, kSoftness };

template <Front kind, bool has_priors, Soft soft>
KG_INLINE ValueExtremes Loop(const PassRow& in, int n, float* __restrict y) {
  const PassRow row = in;  // Local copy: cannot alias y.
  std::int32_t min_bits = kNoMinimum, max_bits = -1;
  for (int c = 0; c < n; ++c) {
    float v = LayersAt<kind>(row, c);
    if constexpr (has_priors) {
      const float p = row.priors[c];
      v += row.weight * (std::abs(p) <= kMaxFloat ? p : 0.0f);
    }
    float value = AtLeast0(v);
    if constexpr (soft == Soft::kInside) {
      value *= row.inside[c] ? row.factor : 1.0f;
    }
    if constexpr (soft == Soft::kSoftness) value *= row.softness[c];
    y[c] = value;
    const std::int32_t high = Bits(value) | -(row.state[c] != kOpen);
    const std::int32_t low = high & kNoMinimum;
    max_bits = high > max_bits ? high : max_bits;
    min_bits = low < min_bits ? low : min_bits;
  }
  return OfBits(min_bits, max_bits);
}

// The row advanced by c columns.
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

// Software prefetch 2 KB ahead while a chunk of the row is computed: the
// hardware prefetcher detects the rows, but too late.
constexpr int kChunk = 128;
constexpr int kAhead = 512;

template <typename T>
KG_INLINE void Fetch(const T* from) {
  if (!from) return;
  // The address may be beyond the raster: a prefetch does not access it.
  const auto begin = reinterpret_cast<std::uintptr_t>(from);
  for (std::size_t i = 0; i < kChunk * sizeof(T); i += 64) {
    __builtin_prefetch(
        reinterpret_cast<const void*>(begin + kAhead * sizeof(T) + i));
  }
}

KG_INLINE void FetchAhead(const PassRow& row) {
  Fetch(row.rows.middle ? row.rows.north : row.values);
  Fetch(row.fronts);
  Fetch(row.priors);
  Fetch(row.inside);
  Fetch(row.state);
}

// The remainder is processed as a full block that begins earlier: cells
// computed twice give the same result.
template <Front kind, bool has_priors, Soft soft>
KG_INLINE ValueExtremes Blocks(const PassRow& row, int n, float* y) {
  if (n < kBlock) return Loop<kind, has_priors, soft>(row, n, y);
  const int whole = n / kBlock * kBlock;
  ValueExtremes found;
  const auto pass = [&](int first, int count) {
    const PassRow part = From(row, first);
    if (row.is_far) FetchAhead(part);
    found = Both(found, Loop<kind, has_priors, soft>(part, count, y + first));
  };
  const int chunk = row.is_far ? kChunk : whole;
  for (int c = 0; c < whole; c += chunk) pass(c, std::min(chunk, whole - c));
  if (whole < n) pass(n - kBlock, kBlock);
  return found;
}

template <Front kind, bool has_priors>
KG_INLINE ValueExtremes LoopBySoft(const PassRow& row, int n, float* y) {
  if (row.inside) return Blocks<kind, has_priors, Soft::kInside>(row, n, y);
  if (row.softness) return Blocks<kind, has_priors, Soft::kSoftness>(row, n, y);
  return Blocks<kind, has_priors, Soft::kNone>(row, n, y);
}

template <Front kind>
KG_INLINE ValueExtremes PassOf(const PassRow& row, int n, float* y) {
  return row.priors ? LoopBySoft<kind, true>(row, n, y)
                    : LoopBySoft<kind, false>(row, n, y);
}

}  // namespace

KG_WIDE ValueExtremes PassBase(const PassRow& row, int n, float* y) {
  return PassOf<Front::kNone>(row, n, y);
}
KG_WIDE ValueExtremes PassStored(const PassRow& row, int n, float* y) {
  return PassOf<Front::kStored>(row, n, y);
}
KG_WIDE ValueExtremes PassSobel(const PassRow& row, int n, float* y) {
  return PassOf<Front::kSobel>(row, n, y);
}
KG_WIDE ValueExtremes PassCentral(const PassRow& row, int n, float* y) {
  return PassOf<Front::kCentral>(row, n, y);
}

}  // namespace kg_compiler
