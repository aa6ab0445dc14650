// The K best paths through a trellis, exact, best first.
//
// Recursive enumeration on the Viterbi table: the n-th best path into a node is
// computed only on demand [1]; here the recursion runs from the end, so "into"
// becomes "out of". Tokens and the resource limit make a path's true score
// differ from that of the table, which is an upper bound: enumeration continues
// until the bound can no longer beat the K-th best found, or
// `enumeration_limit` paths were examined (reported in the result). Two
// measures tighten the bound: tokens that a path can meet twice are unrolled
// (token_unrolling.h), and binding limits get their dual prices
// (resource_prices.h).
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
  std::vector<Path> paths;  // Best first; fewer than K if no more exist.
  bool proven = true;       // False: the enumeration limit was hit first.
  // Upper bound of all allowed paths; valid even if not proven; -infinity = no
  // path exists.
  double bound = -std::numeric_limits<double>::infinity();
  // If a single limit prevents any path: by resource, the minimum excess of a
  // path that keeps the other limits (the path of least use; infinity = this
  // limit alone is not the cause). Else empty.
  std::vector<double> above_limits = {};
};

// Empty if no path crosses all stages, or there are no stages. Throws as
// CheckTrellis() does, and if a mask names an unknown node.
KBest FindKBest(const Trellis& trellis, const PathMasks& masks,
                const KBestOptions& options);

// Bitwise the same result, using what `memory` kept of the last such call
// (k_best_memory.h): for trellises whose last stages are unchanged.
class KBestMemory;
KBest FindKBest(const Trellis& trellis, const PathMasks& masks,
                const KBestOptions& options, KBestMemory* memory);

}  // namespace kg_planner

#endif  // KG_PLANNER_K_BEST_K_BEST_H_
