// Paths that differ from those already chosen: the best path of a thinned
// trellis under a penalty per node, times the number of chosen paths that end a
// stage there, as in the diverse M best of Batra et al. (ECCV 2012). Thinned:
// only the nodes with the largest max-marginals, so that a search is much
// cheaper than a pass over the full trellis.

#ifndef KG_PLANNER_K_BEST_DETOURS_H_
#define KG_PLANNER_K_BEST_DETOURS_H_

#include <cstddef>
#include <vector>

#include "kg_planner/k_best/max_marginals.h"
#include "kg_planner/k_best/search_trellis.h"
#include "kg_planner/trellis/score_grid.h"

namespace kg_planner {

class DetourSearch {
 public:
  // `marginals` must be of the same trellis, grid and prices. `search` must
  // outlive this object.
  DetourSearch(const SearchTrellis& search, const ScoreGrid& grid,
               const Prices& prices, const MaxMarginals& marginals);

  // Registers a chosen path; nodes of the caller's trellis.
  void CountPath(const std::vector<int>& nodes);

  // Seams of the best path; ties: the first in search order.
  std::vector<int> Best(double penalty) const;

 private:
  // Seam between kept nodes, by their index among the kept nodes of their
  // stage.
  struct KeptSeam {
    int from = 0;
    int to = 0;
    int seam = 0;  // Index in the search trellis.
    double weight = 0.0;
  };
  struct KeptStage {
    std::vector<int> nodes;  // Nodes of the search trellis, ascending.
    std::vector<KeptSeam> seams;
    std::vector<int> times_taken;  // Times each kept node was taken.
  };

  void AddSeams(const ScoreGrid& grid, const Prices& prices, std::size_t s);

  const SearchTrellis& search_;
  std::vector<KeptStage> stages_;
};

}  // namespace kg_planner

#endif  // KG_PLANNER_K_BEST_DETOURS_H_
