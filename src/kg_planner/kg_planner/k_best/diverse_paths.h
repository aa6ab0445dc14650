// Diverse paths: the best path through every node, in descending order, each
// taken if it differs from all taken before in at least `minimum_difference`
// stages (a different end node of the stage: Hamming distance). The first is
// the best path overall.
//
// Computed from two Viterbi passes (max_marginals.h) [1]. Tokens that a path
// can meet twice are unrolled there, so each is counted once. Paths worth less
// than `good_enough` of the best are not taken.
//
// A path through another node tends to rejoin the best path soon. If too few
// paths differ enough, the rest are detours at several places (detours.h): the
// best path under a penalty for nodes already used, raised in steps of a tenth
// until it differs enough.
//
// With limits, the best path through a node is searched under prices of the
// resources: zero, then the dual prices, then multiples of them up to the path
// of least use; the first within the limits counts. It need not be the best
// within them: then `proven` is false if that could change the result. A node
// without such a path is left out.
//
// [1] C. Yanover and Y. Weiss, "Finding the M Most Probable Configurations
//     Using Loopy Belief Propagation", NIPS 2003 (max-marginals); the
//     difference as in D. Batra et al., "Diverse M-Best Solutions in Markov
//     Random Fields", ECCV 2012.

#ifndef KG_PLANNER_K_BEST_DIVERSE_PATHS_H_
#define KG_PLANNER_K_BEST_DIVERSE_PATHS_H_

#include <cstddef>
#include <limits>

#include "kg_planner/k_best/k_best.h"
#include "kg_planner/trellis/trellis.h"

namespace kg_planner {

struct DiverseOptions {
  int paths = 10;
  int minimum_difference = 1;  // [stages]; at least 1.
  // Maximum loss against the best score, as a share of |best|: 1 - good_enough;
  // -infinity = no limit.
  double good_enough = -std::numeric_limits<double>::infinity();
  bool detours = true;
  // Paths enumerated for the best one within limits.
  std::size_t enumeration_limit = 100000;
};

// Best first; fewer than requested if no more are found. Throws as FindKBest()
// does. `bound` and `above_limits` refer to the best path; `proven` does not
// cover detours.
KBest FindDiverse(const Trellis& trellis, const PathMasks& masks,
                  const DiverseOptions& options);

}  // namespace kg_planner

#endif  // KG_PLANNER_K_BEST_DIVERSE_PATHS_H_
