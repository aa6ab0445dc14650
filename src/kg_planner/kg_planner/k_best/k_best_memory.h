// State kept from one search for the K best to the next: path suffixes already
// computed. They depend only on later stages, so they are reused as far from
// the end as nothing changed; the result is bitwise that of a search without
// memory.
//
// Changes are detected by comparing the search's inputs: seams and their
// weights on the score grid, after masks, limits and tokens are applied. A
// different grid prevents any reuse. The comparison costs one pass over the
// trellis; the enumeration is saved.

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
  // Number of unchanged stages at the end of the trellis in the last call.
  int reused_stages() const { return reused_stages_; }

  // For FindKBest(): stores the inputs of `search`, and returns the tables of
  // its unchanged end.
  PathEnumerator::Tables Recall(const SearchTrellis& search,
                                const ScoreGrid& grid);
  void Keep(PathEnumerator::Tables tables) { tables_ = std::move(tables); }

 private:
  struct StageRecord {
    int nodes_before = 0;
    std::vector<int> ends;  // `from` and `to` of every seam.
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
