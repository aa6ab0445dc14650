// The paths through a trellis in descending order of their bound
//
//   sum of gains (with every token met) - sum of round(cost + prices .
//   resources),
//
// one at a time; ties in the order of their seams. Recursive enumeration from
// the end: a backward Viterbi pass finds the best suffix from every node; the
// n-th best suffix is computed on demand.

#ifndef KG_PLANNER_K_BEST_PATH_ENUMERATOR_H_
#define KG_PLANNER_K_BEST_PATH_ENUMERATOR_H_

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "kg_planner/k_best/plain_pass.h"
#include "kg_planner/k_best/search_trellis.h"
#include "kg_planner/trellis/score_grid.h"

namespace kg_planner {

class PathEnumerator {
 public:
  struct BoundedPath {
    double bound = 0.0;
    std::vector<int> seams;  // Index of the seam into each stage.
  };

  // A path suffix from a node: `seam`, then the `rank`-th best suffix from its
  // target.
  struct Rest {
    double score = 0.0;
    int seam = -1;
    int rank = 0;
  };
  struct NodeRests {
    std::vector<Rest> best;  // Computed suffixes, best first.
    std::vector<Rest> heap;  // Candidates for the next best.
    bool expanded = false;
  };
  // Suffixes of the nodes before one stage.
  struct LevelRests {
    std::vector<int> index;  // Index into `pool`, by node; -1 = none yet.
    std::vector<NodeRests> pool;
  };
  // Computed suffixes; level s is before stage s and depends only on later
  // stages. Empty levels are not yet known.
  struct Tables {
    std::vector<ViterbiLevel> levels;
    std::vector<LevelRests> rests;
  };

  // `search` must outlive this object. `tables` must be of the same search and
  // prices.
  PathEnumerator(const SearchTrellis& search, const ScoreGrid& grid,
                 Prices prices, Tables tables = {});

  std::optional<BoundedPath> Next();

  // Ends the enumeration and returns its tables.
  Tables Release() { return std::move(tables_); }

 private:
  static bool Worse(const Rest& a, const Rest& b);
  void RelaxStage(std::size_t s);
  double Weight(const SearchStage& stage, int seam) const {
    return stage.Gain(seam) - PricedCost(stage, seam, grid_, prices_);
  }
  double ScoreOver(std::size_t s, int seam) const {
    const SearchStage& stage = search_.stages[s];
    return tables_.levels[s + 1].best[stage.seams[seam].to] +
           Weight(stage, seam);
  }
  NodeRests* Rests(std::size_t s, int node);
  // Suffix of this rank; null if there are fewer. Level s = before stage s.
  const Rest* Get(std::size_t s, int node, int rank);
  void Expand(std::size_t s, int node, NodeRests* rests);
  void PushNext(std::size_t s, NodeRests* rests);

  const SearchTrellis& search_;
  ScoreGrid grid_;
  Prices prices_;
  Tables tables_;
  int next_rank_ = 0;
};

}  // namespace kg_planner

#endif  // KG_PLANNER_K_BEST_PATH_ENUMERATOR_H_
