// Turns tokens that a path can meet more than once into plain gains: a node is
// split by the set of tokens earned before, as in dynamic programming with the
// earned set in the state. Then the Viterbi table is exact for them, not only
// an upper bound.
//
// A seam's gain is the reward beyond what was earned before. Seams from a split
// node keep the order of those from its origin, so paths keep their order.

#ifndef KG_PLANNER_K_BEST_TOKEN_UNROLLING_H_
#define KG_PLANNER_K_BEST_TOKEN_UNROLLING_H_

#include <cstddef>
#include <optional>
#include <vector>

#include "kg_planner/k_best/search_trellis.h"
#include "kg_planner/trellis/score_grid.h"

namespace kg_planner {

// Tokens with a reward in several stages, those with the largest excess first.
std::vector<int> RepeatedTokens(const SearchTrellis& search);

// Unrolls `tokens`; nullopt if that takes more than `max_seams` seams.
std::optional<SearchTrellis> UnrollTokens(const SearchTrellis& search,
                                          const std::vector<int>& tokens,
                                          const ScoreGrid& grid,
                                          std::size_t max_seams);

}  // namespace kg_planner

#endif  // KG_PLANNER_K_BEST_TOKEN_UNROLLING_H_
