#include "kg_compiler/data_plane/row_kernels.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include "kg_compiler/data_plane/wide.h"

namespace kg_compiler {

KG_WIDE void AddWeighted(const float* __restrict p, float weight, int n,
                         float* __restrict v) {
  for (int c = 0; c < n; ++c) {
    const float held = std::abs(p[c]) <= kMaxFloat ? p[c] : 0.0f;
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

KG_WIDE ValueExtremes OpenExtremes(const float* __restrict y,
                                   const unsigned char* __restrict state,
                                   int n) {
  std::int32_t min_bits = kNoMinimum, max_bits = -1;
  for (int c = 0; c < n; ++c) {
    const std::int32_t bits = Bits(y[c]);
    const std::int32_t high = bits | -(state[c] != kOpen);
    const std::int32_t low = high & kNoMinimum;
    max_bits = high > max_bits ? high : max_bits;
    min_bits = low < min_bits ? low : min_bits;
  }
  return OfBits(min_bits, max_bits);
}

namespace {

// Uses a reciprocal: divisions would dominate the run time.
struct HeldScale {
  explicit HeldScale(const RowScale& n)
      : scale(n.scale),
        low(n.low),
        per_range(n.range > 0.0f ? 1.0f / n.range : 0.0f),
        after(n.after) {}
  KG_INLINE float operator()(float y) const {
    const float x = (scale * y - low) * per_range;
    return after * AtMost1(AtLeast0(x));
  }
  const float scale, low, per_range, after;
};

KG_INLINE void FuseLoop(const float* __restrict y,
                        const unsigned char* __restrict state,
                        const HeldScale& scale, int count,
                        float* __restrict u) {
  const HeldScale n = scale;
  for (int c = 0; c < count; ++c) {
    const float held = n(y[c]);
    u[c] = state[c] == kOpen ? held : 0.0f;
  }
}

}  // namespace

KG_WIDE void Normalise(const float* __restrict y, const RowScale& scale,
                       int count, float* __restrict u) {
  const HeldScale n(scale);
  for (int c = 0; c < count; ++c) u[c] = n(y[c]);
}

KG_WIDE void NormaliseOpen(const float* y, const unsigned char* state,
                           const RowScale& scale, int count, float* u) {
  const HeldScale n(scale);
  const int whole = count / kBlock * kBlock;
  const int first = count < kBlock ? 0 : count - kBlock;
  FuseLoop(y, state, n, whole, u);
  if (whole == count) return;
  FuseLoop(y + first, state + first, n, count - first, u + first);
}

KG_WIDE bool AllFinite(const float* __restrict values, int n) {
  std::int32_t bad = 0;
  for (int c = 0; c < n; ++c) bad |= std::abs(values[c]) <= kMaxFloat ? 0 : 1;
  return bad == 0;
}

KG_WIDE ValueMagnitudes MagnitudesOf(const float* __restrict values, int n) {
  std::int32_t max_bits = 0, abs_bits = 0;
  for (int c = 0; c < n; ++c) {
    const float held = std::abs(values[c]) <= kMaxFloat ? values[c] : 0.0f;
    const std::int32_t bits = Bits(held > 0.0f ? held : 0.0f);
    const std::int32_t magnitude = Bits(std::abs(held));
    max_bits = bits > max_bits ? bits : max_bits;
    abs_bits = magnitude > abs_bits ? magnitude : abs_bits;
  }
  return {OfBits(max_bits), OfBits(abs_bits)};
}

KG_WIDE float MaxPositive(const float* __restrict values, int n) {
  std::int32_t max_bits = 0;
  for (int c = 0; c < n; ++c) {
    const std::int32_t bits = Bits(Positive(values[c]));
    max_bits = bits > max_bits ? bits : max_bits;
  }
  return OfBits(max_bits);
}

KG_WIDE float MaxPositiveOpen(const float* __restrict values,
                              const unsigned char* __restrict state, int n) {
  std::int32_t max_bits = 0;
  for (int c = 0; c < n; ++c) {
    const std::int32_t bits = Bits(Positive(values[c])) & -(state[c] == kOpen);
    max_bits = bits > max_bits ? bits : max_bits;
  }
  return OfBits(max_bits);
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
