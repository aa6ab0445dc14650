#include "kg_planner/k_best/k_best_memory.h"

#include <algorithm>
#include <utility>

namespace kg_planner {

PathEnumerator::Tables KBestMemory::Recall(const SearchTrellis& search,
                                           const ScoreGrid& grid) {
  // Inputs of this search, stage by stage.
  std::vector<StageRecord> stages(search.stages.size());
  for (std::size_t s = 0; s < stages.size(); ++s) {
    const SearchStage& stage = search.stages[s];
    stages[s].nodes_before = search.NodesBefore(s);
    for (int i = 0; i < stage.seam_count; ++i) {
      stages[s].ends.push_back(stage.seams[i].from);
      stages[s].ends.push_back(stage.seams[i].to);
    }
    Weigh(stage, grid, {}, &stages[s].weights);
  }
  // Count equal stages from the end. On another grid every score differs, so
  // nothing is reused.
  const std::size_t both = std::min(stages.size(), stages_.size());
  std::size_t same = 0;
  if (grid.step() == step_ && tables_.levels.size() == stages_.size() + 1) {
    while (same < both && stages[stages.size() - 1 - same] ==
                              stages_[stages_.size() - 1 - same]) {
      ++same;
    }
  }
  // Level s depends on the stages from s on only, so the levels of the equal
  // stages are moved over; the others stay empty.
  PathEnumerator::Tables recalled;
  recalled.levels.resize(stages.size() + 1);
  recalled.rests.resize(stages.size() + 1);
  for (std::size_t back = 0; back < same; ++back) {
    const std::size_t from = stages_.size() - 1 - back;
    const std::size_t to = stages.size() - 1 - back;
    recalled.levels[to] = std::move(tables_.levels[from]);
    recalled.rests[to] = std::move(tables_.rests[from]);
  }
  tables_ = {};
  stages_ = std::move(stages);
  step_ = grid.step();
  reused_stages_ = static_cast<int>(same);
  return recalled;
}

}  // namespace kg_planner
