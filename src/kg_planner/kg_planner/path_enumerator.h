// The paths through a trellis in descending order of their bound
//
//   sum of gains (with every token met) - sum of round(cost + prices .
//   resources),
//
// one at a time, the same score by the order of their seams. Recursive
// enumeration from the end: a backward Viterbi pass finds the best rest of a
// path behind every node; the n-th best rest is worked out when asked for.

#ifndef KG_PLANNER_PATH_ENUMERATOR_H_
#define KG_PLANNER_PATH_ENUMERATOR_H_

#include <cstddef>
#include <optional>
#include <vector>

#include "kg_planner/score_grid.h"
#include "kg_planner/search_trellis.h"

namespace kg_planner {

class PathEnumerator {
 public:
  struct BoundedPath {
    double bound = 0.0;
    std::vector<int> seams;  // Index of the seam into each stage.
  };

  // `search` must outlive this.
  PathEnumerator(const SearchTrellis& search, const ScoreGrid& grid,
                 Prices prices);

  std::optional<BoundedPath> Next();

 private:
  // A rest of a path, from a node on: over `seam`, then the `rank`-th best
  // rest from where it leads.
  struct Rest {
    double score = 0.0;
    int seam = -1;
    int rank = 0;
  };
  struct NodeRests {
    std::vector<Rest> best;  // Those worked out, best first.
    std::vector<Rest> heap;  // Candidates for the next.
    bool expanded = false;
  };
  // What leads on from the nodes before a stage.
  struct Level {
    std::vector<double> best;     // By node, of the best rest; -infinity: none.
    std::vector<int> first_seam;  // By node, and one more.
    std::vector<int> rests;       // By node, in `pool`; -1 = none yet.
    std::vector<NodeRests> pool;
  };

  static bool Worse(const Rest& a, const Rest& b);
  void RelaxStage(std::size_t s);
  double Weight(const SearchStage& stage, int seam) const {
    return stage.Gain(seam) - PricedCost(stage, seam, grid_, prices_);
  }
  double Onward(std::size_t s, int seam) const {
    const SearchStage& stage = search_.stages[s];
    return levels_[s + 1].best[stage.seams[seam].to] + Weight(stage, seam);
  }
  NodeRests* Rests(std::size_t s, int node);
  // Null if there are not that many. Level s = before stage s.
  const Rest* Get(std::size_t s, int node, int rank);
  void Expand(std::size_t s, int node, NodeRests* rests);
  void PushNext(std::size_t s, NodeRests* rests);

  const SearchTrellis& search_;
  ScoreGrid grid_;
  Prices prices_;
  std::vector<Level> levels_;
  int next_rank_ = 0;
};

}  // namespace kg_planner

#endif  // KG_PLANNER_PATH_ENUMERATOR_H_
