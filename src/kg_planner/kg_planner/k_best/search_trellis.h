// A trellis as the searches see it: seams grouped by the node they leave, in
// the order of ties, each with what it gains on the score grid (its end, its
// stops on the way, every token met). The bound of a path is
//
//   sum of gains - sum of round(cost + price . resources) .
//
// It refers to the caller's trellis and does not copy what stands well there.

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

  const Stage* stage = nullptr;  // The caller's.
  int nodes = 0;
  const Seam* seams = nullptr;  // Ascending by `from`, then in order of ties.
  int seam_count = 0;
  std::vector<Seam> own;  // What `seams` points to, if not the caller's.
  std::vector<double> node_gain;  // By node.
  std::vector<double> seam_gain;  // By seam; empty = that of its end.
  // By seam: its index in the caller's stage, and its place in the order of
  // ties there; empty = its own index.
  std::vector<int> origin;
  std::vector<int> place;
  std::vector<int> origin_node;  // By node; empty = the node itself.

  int Origin(int seam) const { return origin.empty() ? seam : origin[seam]; }
  int Place(int seam) const { return place.empty() ? seam : place[seam]; }
  int OriginNode(int node) const {
    return origin_node.empty() ? node : origin_node[node];
  }
  double Gain(int seam) const {
    return seam_gain.empty() ? node_gain[seams[seam].to] : seam_gain[seam];
  }
  double Resource(int seam, std::size_t r) const;
  // From now on `seams` are those of `own`.
  void UseOwn();
};

// By resource; empty = no prices.
using Prices = std::vector<double>;

// What seam `i` of `stage` takes off a path's bound.
inline double PricedCost(const SearchStage& stage, int i, const ScoreGrid& grid,
                         const Prices& prices) {
  double cost = stage.seams[i].cost;
  for (std::size_t r = 0; r < prices.size(); ++r) {
    if (prices[r] > 0.0) cost += prices[r] * stage.Resource(i, r);
  }
  return grid.Round(cost);
}

// By seam: its gain less its priced cost.
void Weigh(const SearchStage& stage, const ScoreGrid& grid,
           const Prices& prices, std::vector<double>* weights);

struct SearchTrellis {
  std::vector<SearchStage> stages;

  // Nodes that seams into `stage` come from: one before the first stage.
  int NodesBefore(std::size_t stage) const {
    return stage == 0 ? 1 : stages[stage - 1].nodes;
  }
};

// By resource, the first being 0.
std::vector<double> ResourceLimits(const Trellis& trellis);

// A token's reward at a node that lists it more than once is the largest.
// By token.
std::vector<TokenReward> Distinct(std::vector<TokenReward> tokens);

// The tokens that seam `i` of `stage` meets: at its stops and its end.
std::vector<TokenReward> TokensMet(const Stage& stage, std::size_t i);

// Without what `masks` forbid. `trellis` must be checked and outlive the
// result; `sorted`: by stage, its seams stand in order. Throws
// std::invalid_argument if a mask names a stage or node that is not there; a
// seam mask without a seam forbids nothing.
SearchTrellis ToSearch(const Trellis& trellis, const std::vector<char>& sorted,
                       const PathMasks& masks, const ScoreGrid& grid);

}  // namespace kg_planner

#endif  // KG_PLANNER_K_BEST_SEARCH_TRELLIS_H_
