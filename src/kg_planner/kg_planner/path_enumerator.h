// The paths through a trellis in descending order of their bound
//
//   sum of (rewards + every token met) - sum of (costs + price * resource),
//
// one at a time, the same score by node numbers. Recursive enumeration from the
// end: a backward Viterbi pass finds the best rest of a path behind every node;
// the n-th best rest is worked out when asked for.

#ifndef KG_PLANNER_PATH_ENUMERATOR_H_
#define KG_PLANNER_PATH_ENUMERATOR_H_

#include <cstddef>
#include <optional>
#include <vector>

#include "kg_planner/score_grid.h"
#include "kg_planner/trellis.h"

namespace kg_planner {

// A token's reward at a node that lists it more than once is the largest.
// By token.
std::vector<TokenReward> DistinctTokens(const Node& node);

class PathEnumerator {
 public:
  struct BoundedPath {
    double bound = 0.0;
    std::vector<int> seams;  // Index of the seam into each stage.
  };

  // `trellis` must be checked, its seams ascending by (from, to), and outlive
  // this.
  PathEnumerator(const Trellis& trellis, const ScoreGrid& grid, double price);

  std::optional<BoundedPath> Next();

 private:
  // A rest of a path, from a node on: over `seam`, then the `rank`-th best
  // rest from where it leads.
  struct Rest {
    double score = 0.0;
    int seam = -1;
    int to = 0;
    int rank = 0;
  };
  struct NodeRests {
    std::vector<Rest> best;  // Those worked out, best first.
    std::vector<Rest> heap;  // Candidates for the next.
    int first_seam = 0;      // Those that leave here.
    int seams_end = 0;
    bool expanded = false;
  };

  static bool Worse(const Rest& a, const Rest& b);
  void RelaxStage(std::size_t stage);
  double Price(const Seam& seam) const {
    return grid_.Round(seam.cost + price_ * seam.resource);
  }
  double Weight(std::size_t stage, const Seam& seam) const {
    return gains_[stage][seam.to] - Price(seam);
  }
  // Null if there are not that many. Level s = before stage s.
  const Rest* Get(std::size_t level, int node, int rank);
  void Expand(std::size_t level, NodeRests* rests);
  void PushNext(std::size_t level, NodeRests* rests);

  const Trellis& trellis_;
  ScoreGrid grid_;
  double price_;
  std::vector<std::vector<double>> gains_;      // By stage, node.
  std::vector<std::vector<NodeRests>> levels_;  // By level, node.
  int next_rank_ = 0;
};

}  // namespace kg_planner

#endif  // KG_PLANNER_PATH_ENUMERATOR_H_
