// The best path through every node: a forward and a backward Viterbi pass. The
// max-marginal of a node is the bound of the best path whose stage ends there,
//
//   m(s, v) = best path from the start to v + best path from v to the end .
//
// Ties: the first in the order of ties, as in the K best.

#ifndef KG_PLANNER_K_BEST_MAX_MARGINALS_H_
#define KG_PLANNER_K_BEST_MAX_MARGINALS_H_

#include <cstddef>
#include <vector>

#include "kg_planner/k_best/plain_pass.h"
#include "kg_planner/k_best/search_trellis.h"
#include "kg_planner/trellis/score_grid.h"

namespace kg_planner {

class MaxMarginals {
 public:
  // `search` must outlive this object. `levels`: result of the backward pass
  // under these prices, if available.
  MaxMarginals(const SearchTrellis& search, const ScoreGrid& grid,
               const Prices& prices,
               const std::vector<ViterbiLevel>& levels = {});

  // Max-marginal of a node; -infinity if no path passes it.
  double Score(std::size_t stage, int node) const;

  // Seams of the best path through the node.
  std::vector<int> Seams(std::size_t stage, int node) const;

  // Closes the nodes whose best path differs from `nodes` (of the caller's
  // trellis) in fewer than `minimum_difference` stages.
  void CloseNear(const std::vector<int>& nodes, int minimum_difference);
  bool IsClosed(std::size_t stage, int node) const {
    return levels_[stage + 1].closed[node] != 0;
  }

 private:
  // Values of the nodes before one stage; a seam is -1 if there is none.
  struct Level {
    std::vector<double> before;    // Best bound from the start.
    std::vector<double> behind;    // Best bound to the end.
    std::vector<int> seam_into;    // Best seam in; index in the previous stage.
    std::vector<int> node_before;  // Source node of that seam.
    std::vector<int> seam_on;
    std::vector<int> node_behind;
    std::vector<char> closed;
  };

  // Finds the first seam of the best suffix from known levels.
  void FindSeamsOn(const std::vector<double>& weights, std::size_t s);
  void RelaxBackward(const std::vector<double>& weights, std::size_t s);
  void RelaxForward(const std::vector<double>& weights,
                    const std::vector<int>& order, std::size_t s);
  std::vector<int> OrderOfTies(std::size_t s,
                               const std::vector<int>& order_before) const;

  const SearchTrellis& search_;
  std::vector<Level> levels_;
  // By stage: first seam of each node, then the end.
  std::vector<std::vector<int>> first_seam_;
};

}  // namespace kg_planner

#endif  // KG_PLANNER_K_BEST_MAX_MARGINALS_H_
