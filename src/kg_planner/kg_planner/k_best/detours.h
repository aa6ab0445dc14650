// Paths unlike those already chosen: the best path of a thinned trellis under
// a penalty for every node, times the number of paths taken that end a stage
// there, as in the diverse M best of Batra et al. (ECCV 2012). Thinned: only
// the nodes of the largest max-marginals, so that a search costs next to
// nothing beside a pass over the whole.

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
  // `marginals`: of the same trellis, grid and prices. `search` must outlive
  // this.
  DetourSearch(const SearchTrellis& search, const ScoreGrid& grid,
               const Prices& prices, const MaxMarginals& marginals);

  // A path that was taken: nodes of the caller's trellis.
  void CountPath(const std::vector<int>& nodes);

  // The seams of the best path; of equal ones the first of the search.
  std::vector<int> Best(double penalty) const;

 private:
  // Between kept nodes, by their place among those of their stage.
  struct KeptSeam {
    int from = 0;
    int to = 0;
    int seam = 0;  // Index in the search trellis.
    double weight = 0.0;
  };
  struct KeptStage {
    std::vector<int> nodes;  // Nodes of the search trellis, ascending.
    std::vector<KeptSeam> seams;
    std::vector<int> times_taken;  // By kept node.
  };

  void AddSeams(const ScoreGrid& grid, const Prices& prices, std::size_t s);

  const SearchTrellis& search_;
  std::vector<KeptStage> stages_;
};

}  // namespace kg_planner

#endif  // KG_PLANNER_K_BEST_DETOURS_H_
