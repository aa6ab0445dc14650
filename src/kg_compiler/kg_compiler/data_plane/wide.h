// What the inner loops are written with: functions for several vector widths,
// and floats compared by their bits. For the kernels' own files, which are
// compiled without fused multiply and add.

#ifndef KG_COMPILER_DATA_PLANE_WIDE_H_
#define KG_COMPILER_DATA_PLANE_WIDE_H_

#include <cstdint>
#include <cstring>
#include <limits>

#include "kg_compiler/data_plane/pass_kernels.h"

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

inline constexpr float kMost = std::numeric_limits<float>::max();

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

// Of anything but NaN, in one instruction.
inline float AtLeast0(float x) {
  const std::int32_t bits = Bits(x);
  return OfBits(bits > 0 ? bits : 0);
}
inline constexpr std::int32_t kOneBits = 0x3f800000;
inline float AtMost1(float positive) {
  const std::int32_t bits = Bits(positive);
  return OfBits(bits < kOneBits ? bits : kOneBits);
}

inline constexpr std::int32_t kNoneLeast =
    std::numeric_limits<std::int32_t>::max();

// A cell that does not count has all bits set: below every other as a candidate
// for the largest, above as one for the least but for its sign.
inline ValueExtremes OfBits(std::int32_t least, std::int32_t most) {
  if (most < 0) return {};
  return {OfBits(least), OfBits(most)};
}

// Cells that fill the vectors.
inline constexpr int kBlock = 32;

}  // namespace kg_compiler

#endif  // KG_COMPILER_DATA_PLANE_WIDE_H_
