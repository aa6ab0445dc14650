// The K best paths through a trellis, exact, best first.
//
// Recursive enumeration on the Viterbi table: the n-th best path into a node is
// worked out only when asked for [1]; here from the end, so into becomes out
// of. Tokens and the resource limit make a path's true score differ from the
// table's, which is an upper bound: enumeration goes on until the bound can no
// longer beat the K-th best found, or `enumeration_limit` paths were looked at
// (then the result says so). Two things keep the bound close: tokens that a
// path can meet twice are unrolled (token_unrolling.h), and binding limits get
// their dual prices (resource_prices.h).
//
// Ties by node numbers, lexicographically (parallel seams: stage by stage by
// node, then via): the answer is deterministic. Scores are compared on a grid
// of 2^-50 of the largest total (score_grid.h).
//
// [1] V. M. Jimenez and A. Marzal, "Computing the K Shortest Paths: A New
//     Algorithm and an Experimental Comparison", WAE 1999, LNCS 1668, 15-29.

#ifndef KG_PLANNER_K_BEST_K_BEST_H_
#define KG_PLANNER_K_BEST_K_BEST_H_

#include <cstddef>
#include <limits>
#include <vector>

#include "kg_planner/k_best/path.h"
#include "kg_planner/trellis/trellis.h"

namespace kg_planner {

struct KBestOptions {
  int paths = 10;
  std::size_t enumeration_limit = 100000;
};

struct KBest {
  std::vector<Path> paths;  // Best first; fewer than asked if there are fewer.
  bool proven = true;       // False: the enumeration limit was hit first.
  // No allowed path scores more, proven or not; -infinity = there is none.
  double bound = -std::numeric_limits<double>::infinity();
  // If there is no path, but for one limit there would be: by how much, at
  // least, a path that keeps the other limits is above it, by resource (the
  // thriftiest path; infinity = this limit is not to blame alone). Else empty.
  std::vector<double> above_limits = {};
};

// Empty if no path crosses all stages, or there are none. Throws as
// CheckTrellis() does, and if a mask names a node that is not there.
KBest FindKBest(const Trellis& trellis, const PathMasks& masks,
                const KBestOptions& options);

// The same, to the bit, with what `memory` keeps of the last such call
// (k_best_memory.h): for a trellis whose end did not change since.
class KBestMemory;
KBest FindKBest(const Trellis& trellis, const PathMasks& masks,
                const KBestOptions& options, KBestMemory* memory);

}  // namespace kg_planner

#endif  // KG_PLANNER_K_BEST_K_BEST_H_
