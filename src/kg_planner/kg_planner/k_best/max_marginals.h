// The best path through every node: a forward and a backward Viterbi pass. The
// max-marginal of a node is the bound of the best path whose stage ends there,
//
//   m(s, v) = best way from the start to v + best rest from v on .
//
// Of equal ones the first in the order of ties, as in the K best.

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
  // `search` must outlive this. `levels`: of the backward pass under these
  // prices, if there was one.
  MaxMarginals(const SearchTrellis& search, const ScoreGrid& grid,
               const Prices& prices,
               const std::vector<ViterbiLevel>& levels = {});

  // -infinity if no path leads through the node.
  double Score(std::size_t stage, int node) const;

  // The seams of the best path through the node.
  std::vector<int> Seams(std::size_t stage, int node) const;

  // Marks the nodes whose best path ends in other nodes than `nodes` (those of
  // the caller's trellis) in fewer than `minimum_difference` stages.
  void CloseNear(const std::vector<int>& nodes, int minimum_difference);
  bool IsClosed(std::size_t stage, int node) const {
    return levels_[stage + 1].closed[node] != 0;
  }

 private:
  // The nodes before one stage; a seam is -1 where there is none.
  struct Level {
    std::vector<double> before;    // Best bound from the start.
    std::vector<double> behind;    // Best bound to the end.
    std::vector<int> seam_into;    // Index in the stage before.
    std::vector<int> node_before;  // Where that seam comes from.
    std::vector<int> seam_on;
    std::vector<int> node_behind;
    std::vector<char> closed;
  };

  // The first seam of the best rest, where that is known.
  void FindSeamsOn(const std::vector<double>& weights, std::size_t s);
  void RelaxBackward(const std::vector<double>& weights, std::size_t s);
  void RelaxForward(const std::vector<double>& weights,
                    const std::vector<int>& order, std::size_t s);
  std::vector<int> OrderOfTies(std::size_t s,
                               const std::vector<int>& order_before) const;

  const SearchTrellis& search_;
  std::vector<Level> levels_;
  std::vector<std::vector<int>> first_seam_;  // By stage: of every node, end.
};

}  // namespace kg_planner

#endif  // KG_PLANNER_K_BEST_MAX_MARGINALS_H_
