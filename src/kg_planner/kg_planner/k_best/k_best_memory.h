// What a search for the K best leaves behind for the next one: the rests of
// paths that were worked out. They depend on what comes behind a stage only, so
// as far from the end as nothing changed they are taken over, and the result is
// that of a search without memory, to the bit.
//
// What changed is found by comparison of what the search reads: seams and their
// weights on the score grid, after masks, limits and tokens have had their
// effect. So nothing is reused when the grid is another. Comparing costs a pass
// over the trellis; what is saved is the enumeration.

#ifndef KG_PLANNER_K_BEST_K_BEST_MEMORY_H_
#define KG_PLANNER_K_BEST_K_BEST_MEMORY_H_

#include <utility>
#include <vector>

#include "kg_planner/k_best/path_enumerator.h"
#include "kg_planner/k_best/search_trellis.h"
#include "kg_planner/trellis/score_grid.h"

namespace kg_planner {

class KBestMemory {
 public:
  // Stages at the end of the last call's trellis that were as before.
  int reused_stages() const { return reused_stages_; }

  // For FindKBest(): keeps what `search` looks like, and gives the tables of
  // its unchanged end.
  PathEnumerator::Tables Recall(const SearchTrellis& search,
                                const ScoreGrid& grid);
  void Keep(PathEnumerator::Tables tables) { tables_ = std::move(tables); }

 private:
  struct StageRecord {
    int nodes_before = 0;
    std::vector<int> ends;  // From and to of every seam.
    std::vector<double> weights;
    bool operator==(const StageRecord& other) const {
      return nodes_before == other.nodes_before && ends == other.ends &&
             weights == other.weights;
    }
  };

  double step_ = 0.0;  // Step of the grid.
  std::vector<StageRecord> stages_;
  PathEnumerator::Tables tables_;
  int reused_stages_ = 0;
};

}  // namespace kg_planner

#endif  // KG_PLANNER_K_BEST_K_BEST_MEMORY_H_
