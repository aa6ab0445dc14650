// Tokens that a path can meet more than once, turned into plain rewards: a node
// is split by which of them the path has earned before, as in dynamic
// programming with the earned set in the state. Then the Viterbi table is exact
// for them, not only an upper bound.
//
// A split node's reward is what is gained there beyond what was earned before.
// Nodes are numbered so that paths keep their lexicographic order.

#ifndef KG_PLANNER_TOKEN_UNROLLING_H_
#define KG_PLANNER_TOKEN_UNROLLING_H_

#include <cstddef>
#include <optional>
#include <vector>

#include "kg_planner/score_grid.h"
#include "kg_planner/trellis.h"

namespace kg_planner {

struct Unrolled {
  Trellis trellis;
  std::vector<std::vector<int>> origin;  // By stage, split node: the node.
};

// Tokens with a reward in several stages, those that matter most first.
std::vector<int> RepeatedTokens(const Trellis& trellis);

// Unrolls `tokens`; nothing if that takes more than `max_seams` seams. Seams of
// `trellis` must ascend by (from, to); so do the result's.
std::optional<Unrolled> UnrollTokens(const Trellis& trellis,
                                     const std::vector<int>& tokens,
                                     const ScoreGrid& grid,
                                     std::size_t max_seams);

}  // namespace kg_planner

#endif  // KG_PLANNER_TOKEN_UNROLLING_H_
