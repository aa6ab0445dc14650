#include "kg_planner/k_best/path_value.h"

#include <cstddef>
#include <utility>

#include "kg_planner/trellis/trellis_check.h"

namespace kg_planner {
namespace {

class PathValuation {
 public:
  PathValuation(const Trellis& trellis, const ScoreGrid& grid)
      : trellis_(trellis), grid_(grid) {
    value_.path.more_resources.assign(trellis.more_limits.size(), 0.0);
    value_.path.nodes.reserve(trellis.stages.size());
    value_.path.seams.reserve(trellis.stages.size());
    value_.places.reserve(trellis.stages.size());
  }

  void AddSeam(std::size_t s, int index, int place) {
    const Stage& stage = trellis_.stages[s];
    const Seam& seam = stage.seams[index];
    for (const int node : NodesVia(stage, index)) AddNode(stage.nodes[node]);
    AddNode(stage.nodes[seam.to]);
    value_.path.nodes.push_back(seam.to);
    value_.path.seams.push_back(index);
    value_.places.push_back(place);
    value_.path.cost += seam.cost;
    value_.score -= grid_.Round(seam.cost);
    value_.path.resource += seam.resource;
    for (std::size_t r = 0; r < value_.path.more_resources.size(); ++r) {
      value_.path.more_resources[r] += stage.more_resources[r][index];
    }
  }

  ValuedPath Finish() {
    for (const TokenReward& token : Distinct(std::move(met_))) {
      value_.path.reward += token.reward;
      value_.score += grid_.Round(token.reward);
    }
    return std::move(value_);
  }

 private:
  void AddNode(const Node& node) {
    value_.path.reward += node.reward;
    value_.score += grid_.Round(node.reward);
    met_.insert(met_.end(), node.tokens.begin(), node.tokens.end());
  }

  const Trellis& trellis_;
  ScoreGrid grid_;
  ValuedPath value_;
  std::vector<TokenReward> met_;
};

}  // namespace

bool IsBetter(const ValuedPath& a, const ValuedPath& b) {
  if (a.score != b.score) return a.score > b.score;
  return a.places < b.places;
}

ValuedPath Evaluate(const Trellis& trellis, const ScoreGrid& grid,
                    const SearchTrellis& search,
                    const std::vector<int>& seams) {
  PathValuation valuation(trellis, grid);
  for (std::size_t s = 0; s < seams.size(); ++s) {
    const SearchStage& stage = search.stages[s];
    valuation.AddSeam(s, stage.Origin(seams[s]), stage.Place(seams[s]));
  }
  return valuation.Finish();
}

bool IsWithinLimits(const Trellis& trellis, const Path& path) {
  if (!(path.resource <= trellis.resource_limit)) return false;
  for (std::size_t r = 0; r < path.more_resources.size(); ++r) {
    if (!(path.more_resources[r] <= trellis.more_limits[r])) return false;
  }
  return true;
}

}  // namespace kg_planner
