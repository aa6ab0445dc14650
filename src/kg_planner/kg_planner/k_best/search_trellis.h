// A trellis in the form used by the searches: seams grouped by source node, in
// the order of ties, each with its gain on the score grid (its end, its stops
// on the way, every token met). The bound of a path is
//
//   sum of gains - sum of round(cost + price . resources) .
//
// References the caller's trellis; copies seams only where it must change them.

#ifndef KG_PLANNER_K_BEST_SEARCH_TRELLIS_H_
#define KG_PLANNER_K_BEST_SEARCH_TRELLIS_H_

#include <cstddef>
#include <vector>

#include "kg_planner/k_best/path.h"
#include "kg_planner/trellis/score_grid.h"
#include "kg_planner/trellis/trellis.h"

namespace kg_planner {

struct SearchStage {
  SearchStage() = default;
  SearchStage(SearchStage&&) = default;
  SearchStage& operator=(SearchStage&&) = default;
  SearchStage(const SearchStage&) = delete;
  SearchStage& operator=(const SearchStage&) = delete;

  const Stage* stage = nullptr;  // Stage of the caller's trellis.
  int nodes = 0;
  const Seam* seams = nullptr;  // Ascending by `from`, then in order of ties.
  int seam_count = 0;
  std::vector<Seam> own;          // Storage of `seams` if not the caller's.
  std::vector<double> node_gain;  // Gain by node.
  std::vector<double> seam_gain;  // Gain by seam; empty = node_gain of its end.
  // By seam: its index in the caller's stage, and its rank in the order of ties
  // there; empty = its own index.
  std::vector<int> origin;
  std::vector<int> place;
  std::vector<int> origin_node;  // Caller's node; empty = identical.

  int Origin(int seam) const { return origin.empty() ? seam : origin[seam]; }
  int Place(int seam) const { return place.empty() ? seam : place[seam]; }
  int OriginNode(int node) const {
    return origin_node.empty() ? node : origin_node[node];
  }
  double Gain(int seam) const {
    return seam_gain.empty() ? node_gain[seams[seam].to] : seam_gain[seam];
  }
  double Resource(int seam, std::size_t r) const;
  // Points `seams` to `own`.
  void UseOwn();
};

// Price by resource; empty = no prices.
using Prices = std::vector<double>;

// Cost of seam `i` of `stage` in the bound of a path, prices included.
inline double PricedCost(const SearchStage& stage, int i, const ScoreGrid& grid,
                         const Prices& prices) {
  double cost = stage.seams[i].cost;
  for (std::size_t r = 0; r < prices.size(); ++r) {
    if (prices[r] > 0.0) cost += prices[r] * stage.Resource(i, r);
  }
  return grid.Round(cost);
}

// Weight of each seam: gain - priced cost.
void Weigh(const SearchStage& stage, const ScoreGrid& grid,
           const Prices& prices, std::vector<double>* weights);

struct SearchTrellis {
  std::vector<SearchStage> stages;

  // Number of source nodes of `stage`: 1 for the first stage.
  int NodesBefore(std::size_t stage) const {
    return stage == 0 ? 1 : stages[stage - 1].nodes;
  }
};

// Limits by resource, starting with resource 0.
std::vector<double> ResourceLimits(const Trellis& trellis);

// Merges duplicate tokens, keeping the largest reward; sorted by token.
std::vector<TokenReward> Distinct(std::vector<TokenReward> tokens);

// Tokens that seam `i` of `stage` meets: at its stops and its end.
std::vector<TokenReward> TokensMet(const Stage& stage, std::size_t i);

// Builds the search trellis without masked nodes and seams. `trellis` must be
// checked and outlive the result; `sorted`: by stage, whether its seams are in
// order. Throws std::invalid_argument if a mask names an unknown stage or node;
// a mask of a nonexistent seam has no effect.
SearchTrellis ToSearch(const Trellis& trellis, const std::vector<char>& sorted,
                       const PathMasks& masks, const ScoreGrid& grid);

}  // namespace kg_planner

#endif  // KG_PLANNER_K_BEST_SEARCH_TRELLIS_H_
