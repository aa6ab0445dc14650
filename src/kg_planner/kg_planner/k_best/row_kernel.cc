#include "kg_planner/k_best/row_kernel.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

// One function compiled for several instruction sets; the dynamic linker
// selects the best. Not under sanitizers, which are not initialised at that
// point.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define KG_WIDE __attribute__((target_clones("avx2", "default")))
#else
#define KG_WIDE
#endif

#define KG_INLINE inline __attribute__((always_inline))

#include "kg_planner/k_best/no_value.h"

namespace kg_planner {
namespace {

// Four seams are loaded as three vectors of four words,
//
//   e0 c0 r0 e1 | c1 r1 e2 c2 | r2 e3 c3 r3      e = to << 32 | from,
//
// c = cost and r = resource. On big-endian machines, where e has the other
// order, no row counts as sound here and all are checked individually
// elsewhere.
static_assert(sizeof(Seam) == 24 && offsetof(Seam, cost) == 8 &&
                  offsetof(Seam, resource) == 16,
              "a seam is three words");

using Reals = double __attribute__((vector_size(32)));
using Words = std::uint64_t __attribute__((vector_size(32)));
using LooseReals = double __attribute__((vector_size(32), aligned(8)));
using LooseWords =
    std::uint64_t __attribute__((vector_size(32), aligned(8), may_alias));

constexpr std::uint64_t kNextTo = std::uint64_t{1} << 32;
// Added to a nonfinite value this carries into the sign bit; never for a valid
// e.
constexpr std::uint64_t kExponentOne = std::uint64_t{1} << 52;

KG_INLINE std::uint64_t Bits(double x) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &x, sizeof bits);
  return bits;
}

KG_INLINE std::uint64_t Ends(const Seam& seam) {
  return std::uint64_t{static_cast<std::uint32_t>(seam.to)} << 32 |
         static_cast<std::uint32_t>(seam.from);
}

// State of the scan: bit 63 of `bad`, and bits 63 and 31 to 0 of `ends`, are 0
// while all seams are valid.
struct RowSums {
  double best = kNone;
  double largest_cost = 0.0;
  std::uint64_t bad = 0;
  std::uint64_t ends = 0;
};

KG_INLINE void AddOne(const Seam* seam, bool first, double onward, double shift,
                      RowSums* sums) {
  sums->best = std::max(sums->best, onward - ((seam->cost + shift) - shift));
  sums->largest_cost = std::max(sums->largest_cost, seam->cost);
  const std::uint64_t cost = Bits(seam->cost);
  const std::uint64_t resource = Bits(seam->resource);
  sums->bad |= Ends(*seam) | cost | (cost + kExponentOne) | resource |
               (resource + kExponentOne);
  if (!first) sums->ends |= Ends(*seam) - Ends(seam[-1]) - kNextTo;
}

struct VectorLanes {
  Words bad = {};
  Words ends[3] = {};
  Reals max_value[3] = {};
  Reals best = {kNone, kNone, kNone, kNone};
};

// `onward`: suffix scores of seams 1, 0, 3, 2.
KG_INLINE void AddFour(const Seam* seams, const Reals& onward, double shift,
                       VectorLanes* lanes) {
  // Each vector of words is compared with the one a seam (24 bytes) before it:
  // ends must ascend, costs and resources be finite and >= 0.
  const char* bytes = reinterpret_cast<const char*>(seams);
  Reals reals[3];
  for (int i = 0; i < 3; ++i) {
    const Words words = *reinterpret_cast<const LooseWords*>(bytes + 32 * i);
    const Words before =
        *reinterpret_cast<const LooseWords*>(bytes + 32 * i - sizeof(Seam));
    lanes->ends[i] |= words - before - kNextTo;
    lanes->bad |= words | (words + kExponentOne);
    reals[i] = reinterpret_cast<Reals>(words);
    lanes->max_value[i] =
        reals[i] > lanes->max_value[i] ? reals[i] : lanes->max_value[i];
  }
  // Costs of seams 1, 0, 3, 2 are in lanes c1 | c0 | c3 | c2 of the three
  // vectors.
  const Reals costs_102 =
      __builtin_shufflevector(reals[0], reals[1], 4, 1, 2, 7);
  const Reals costs = __builtin_shufflevector(costs_102, reals[2], 0, 1, 6, 3);
  const Reals scores = onward - ((costs + shift) - shift);
  lanes->best = scores > lanes->best ? scores : lanes->best;
}

KG_INLINE RowScan Finish(const VectorLanes& lanes, RowSums sums) {
  for (int i = 0; i < 4; ++i) {
    sums.best = std::max(sums.best, lanes.best[i]);
    sums.bad |= lanes.bad[i];
  }
  sums.ends |=
      lanes.ends[0][0] | lanes.ends[0][3] | lanes.ends[1][2] | lanes.ends[2][1];
  sums.largest_cost =
      std::max({sums.largest_cost, lanes.max_value[0][1], lanes.max_value[1][0],
                lanes.max_value[1][3], lanes.max_value[2][2]});
  const bool sound = sums.bad >> 63 == 0 && sums.ends >> 63 == 0 &&
                     static_cast<std::uint32_t>(sums.ends) == 0;
  return {sums.best, sums.largest_cost, sound};
}

// Row that contains every node from the first `to` to the last.
KG_INLINE RowScan ScanWhole(const Seam* seams, int count,
                            const OnwardScores& onward) {
  const double* by_seam = onward.by_node + seams->to;
  RowSums sums;
  VectorLanes lanes;
  AddOne(seams, true, by_seam[0], onward.shift, &sums);
  int i = 1;
  for (; i + 4 <= count; i += 4) {
    const Reals four = *reinterpret_cast<const LooseReals*>(by_seam + i);
    AddFour(seams + i, __builtin_shufflevector(four, four, 1, 0, 3, 2),
            onward.shift, &lanes);
  }
  for (; i < count; ++i) {
    AddOne(seams + i, false, by_seam[i], onward.shift, &sums);
  }
  return Finish(lanes, sums);
}

KG_INLINE double Look(const OnwardScores& onward, const Seam& seam) {
  const auto last = static_cast<std::uint32_t>(onward.nodes - 1);
  return onward.by_node[std::min(static_cast<std::uint32_t>(seam.to), last)];
}

KG_INLINE RowScan ScanSparse(const Seam* seams, int count,
                             const OnwardScores& onward) {
  RowSums sums;
  VectorLanes lanes;
  AddOne(seams, true, Look(onward, seams[0]), onward.shift, &sums);
  int i = 1;
  for (; i + 4 <= count; i += 4) {
    const Seam* four = seams + i;
    const Reals there = {Look(onward, four[1]), Look(onward, four[0]),
                         Look(onward, four[3]), Look(onward, four[2])};
    AddFour(four, there, onward.shift, &lanes);
  }
  for (; i < count; ++i) {
    AddOne(seams + i, false, Look(onward, seams[i]), onward.shift, &sums);
  }
  return Finish(lanes, sums);
}

}  // namespace

KG_WIDE RowScan ScanRow(const Seam* seams, int count,
                        const OnwardScores& onward) {
  const bool whole = seams[count - 1].to - seams[0].to == count - 1;
  return whole ? ScanWhole(seams, count, onward)
               : ScanSparse(seams, count, onward);
}

}  // namespace kg_planner
