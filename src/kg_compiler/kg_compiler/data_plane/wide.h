// Building blocks of the inner loops: functions compiled for several vector
// widths, and floats compared by their bits. Only for the kernels' own files,
// which are compiled without fused multiply and add.

#ifndef KG_COMPILER_DATA_PLANE_WIDE_H_
#define KG_COMPILER_DATA_PLANE_WIDE_H_

#include <cstdint>
#include <cstring>
#include <limits>

#include "kg_compiler/data_plane/extremes.h"

// Compiles a function for several instruction sets; the dynamic linker selects
// the best one. Disabled under sanitizers, which are not yet initialised then.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define KG_WIDE __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define KG_WIDE
#endif

#define KG_INLINE inline __attribute__((always_inline))

namespace kg_compiler {

inline constexpr float kMaxFloat = std::numeric_limits<float>::max();

inline float Positive(float x) {
  const float held = x <= kMaxFloat ? x : 0.0f;
  return held > 0.0f ? held : 0.0f;
}

// Floats >= 0 have the order of their bit patterns. The integer maximum can be
// vectorised without reordering floating-point operations.
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

// max(0, x) in one instruction; x is not NaN.
inline float AtLeast0(float x) {
  const std::int32_t bits = Bits(x);
  return OfBits(bits > 0 ? bits : 0);
}
inline constexpr std::int32_t kOneBits = 0x3f800000;
inline float AtMost1(float positive) {
  const std::int32_t bits = Bits(positive);
  return OfBits(bits < kOneBits ? bits : kOneBits);
}

inline constexpr std::int32_t kNoMinimum =
    std::numeric_limits<std::int32_t>::max();

// Extremes from bits. A cell that does not count has all bits set: as a signed
// integer (-1) it is below every candidate for the maximum, and without its
// sign bit above every candidate for the minimum.
inline ValueExtremes OfBits(std::int32_t min_bits, std::int32_t max_bits) {
  if (max_bits < 0) return {};
  return {OfBits(min_bits), OfBits(max_bits)};
}

// Cells per block: a whole number of vectors at every width.
inline constexpr int kBlock = 32;

}  // namespace kg_compiler

#endif  // KG_COMPILER_DATA_PLANE_WIDE_H_
