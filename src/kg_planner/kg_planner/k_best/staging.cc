#include "kg_planner/k_best/staging.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <stdexcept>
#include <string>

#include "kg_planner/k_best/search_trellis.h"
#include "kg_planner/trellis/score_grid.h"
#include "kg_planner/trellis/trellis_check.h"

namespace kg_planner {
namespace {

void CheckPath(const Trellis& trellis, const Path& path) {
  if (path.seams.size() != trellis.stages.size()) {
    throw std::invalid_argument("path: " + std::to_string(path.seams.size()) +
                                " seams, expected " +
                                std::to_string(trellis.stages.size()));
  }
  int at = 0;
  for (std::size_t s = 0; s < path.seams.size(); ++s) {
    const auto& seams = trellis.stages[s].seams;
    const int i = path.seams[s];
    if (i < 0 || static_cast<std::size_t>(i) >= seams.size() ||
        seams[i].from != at) {
      throw std::invalid_argument(
          "path: seam " + std::to_string(i) + " of stage " + std::to_string(s) +
          " does not lead on from node " + std::to_string(at));
    }
    at = seams[i].to;
  }
}

class TokenEarnings {
 public:
  explicit TokenEarnings(const ScoreGrid& grid) : grid_(grid) {}

  // Immediate gain of seam i of the stage.
  double ImmediateGain(const Stage& stage, int i) const {
    double gain = grid_.Round(stage.nodes[stage.seams[i].to].reward) -
                  grid_.Round(stage.seams[i].cost);
    for (const int node : NodesVia(stage, i)) {
      gain += grid_.Round(stage.nodes[node].reward);
    }
    for (const TokenReward& token : TokensMet(stage, i)) {
      gain += std::max(0.0, grid_.Round(token.reward) - Earned(token.token));
    }
    return gain;
  }
  void Earn(const Stage& stage, int i) {
    for (const TokenReward& token : TokensMet(stage, i)) {
      double& earned = earned_[token.token];
      earned = std::max(earned, grid_.Round(token.reward));
    }
  }

 private:
  double Earned(int token) const {
    const auto known = earned_.find(token);
    return known == earned_.end() ? 0.0 : known->second;
  }

  ScoreGrid grid_;
  std::map<int, double> earned_;  // Reward earned so far, by token.
};

}  // namespace

std::vector<bool> FindStaging(const Trellis& trellis, const PathMasks& masks,
                              const Path& path) {
  const TrellisSummary summary = CheckTrellis(trellis);
  CheckPath(trellis, path);
  const ScoreGrid grid(summary.largest_total);
  const SearchTrellis allowed = ToSearch(trellis, summary.sorted, masks, grid);
  TokenEarnings earnings(grid);
  std::vector<bool> staging;
  int at = 0;
  for (std::size_t s = 0; s < path.seams.size(); ++s) {
    const Stage& stage = trellis.stages[s];
    const SearchStage& search = allowed.stages[s];
    // Does another allowed seam from here have a larger immediate gain?
    const double taken = earnings.ImmediateGain(stage, path.seams[s]);
    bool more = false;
    for (int i = 0; i < search.seam_count; ++i) {
      more = more || (search.seams[i].from == at &&
                      earnings.ImmediateGain(stage, search.Origin(i)) > taken);
    }
    staging.push_back(more);
    earnings.Earn(stage, path.seams[s]);
    at = stage.seams[path.seams[s]].to;
  }
  return staging;
}

}  // namespace kg_planner
