#include "kg_planner/reduction.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "kg_planner/survey.h"

namespace kg_planner {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

using Levels = std::vector<std::vector<double>>;

void CheckIndex(const char* what, int index, std::size_t size) {
  if (index >= 0 && static_cast<std::size_t>(index) < size) return;
  throw std::invalid_argument(std::string("mask: ") + what + " " +
                              std::to_string(index) + " of " +
                              std::to_string(size));
}

void CheckMasks(const Trellis& trellis, const Masks& masks) {
  const auto& stages = trellis.stages;
  for (const NodeMask& mask : masks.nodes) {
    CheckIndex("stage", mask.stage, stages.size());
    CheckIndex("node", mask.node, stages[mask.stage].nodes.size());
  }
  for (const SeamMask& mask : masks.seams) {
    CheckIndex("stage", mask.stage, stages.size());
    CheckIndex("from", mask.from, NodesBefore(trellis, mask.stage));
    CheckIndex("to", mask.to, stages[mask.stage].nodes.size());
  }
}

using Pair = std::pair<int, int>;

struct StageMasks {
  std::vector<char> nodes;
  std::vector<Pair> seams;  // Ascending.
};

std::vector<StageMasks> ByStage(const Trellis& trellis, const Masks& masks) {
  std::vector<StageMasks> by_stage(trellis.stages.size());
  for (std::size_t s = 0; s < by_stage.size(); ++s)
    by_stage[s].nodes.resize(trellis.stages[s].nodes.size());
  for (const NodeMask& mask : masks.nodes)
    by_stage[mask.stage].nodes[mask.node] = 1;
  for (const SeamMask& mask : masks.seams)
    by_stage[mask.stage].seams.emplace_back(mask.from, mask.to);
  for (StageMasks& stage : by_stage)
    std::sort(stage.seams.begin(), stage.seams.end());
  return by_stage;
}

bool ByEnds(const Seam& a, const Seam& b) {
  return Pair(a.from, a.to) < Pair(b.from, b.to);
}

// Least resource from the start to every node.
Levels LeastBefore(const Trellis& trellis) {
  Levels least{{0.0}};
  for (const Stage& stage : trellis.stages) {
    std::vector<double> next(stage.nodes.size(), kNever);
    for (const Seam& seam : stage.seams)
      next[seam.to] =
          std::min(next[seam.to], least.back()[seam.from] + seam.resource);
    least.push_back(std::move(next));
  }
  return least;
}

// Least resource from every node to the end; level 0 = the start.
Levels LeastBehind(const Trellis& trellis) {
  const std::size_t stages = trellis.stages.size();
  Levels least(stages + 1);
  least[stages].assign(NodesBefore(trellis, stages), 0.0);
  for (std::size_t s = stages; s-- > 0;) {
    least[s].assign(NodesBefore(trellis, s), kNever);
    for (const Seam& seam : trellis.stages[s].seams)
      least[s][seam.from] =
          std::min(least[s][seam.from], seam.resource + least[s + 1][seam.to]);
  }
  return least;
}

}  // namespace

Trellis ApplyMasks(const Trellis& trellis, const Masks& masks) {
  CheckMasks(trellis, masks);
  const std::vector<StageMasks> by_stage = ByStage(trellis, masks);
  Trellis left;
  left.resource_limit = trellis.resource_limit;
  left.stages.resize(trellis.stages.size());
  for (std::size_t s = 0; s < left.stages.size(); ++s) {
    const StageMasks& stage = by_stage[s];
    left.stages[s].nodes = trellis.stages[s].nodes;
    std::vector<Seam>& seams = left.stages[s].seams;
    for (const Seam& seam : trellis.stages[s].seams) {
      if (stage.nodes[seam.to] || (s > 0 && by_stage[s - 1].nodes[seam.from]))
        continue;
      if (!std::binary_search(stage.seams.begin(), stage.seams.end(),
                              Pair(seam.from, seam.to)))
        seams.push_back(seam);
    }
    if (!std::is_sorted(seams.begin(), seams.end(), ByEnds))
      std::sort(seams.begin(), seams.end(), ByEnds);
  }
  return left;
}

// Sums in another order than a path's own differ by rounding: a hair is left.
Trellis DropUnaffordable(Trellis trellis) {
  const Levels before = LeastBefore(trellis);
  const Levels behind = LeastBehind(trellis);
  const double limit = trellis.resource_limit;
  const double most = limit < kNever ? limit + 1e-9 * std::max(limit, 0.0)
                                     : std::numeric_limits<double>::max();
  for (std::size_t s = 0; s < trellis.stages.size(); ++s) {
    std::vector<Seam>& seams = trellis.stages[s].seams;
    const auto useless = [&](const Seam& seam) {
      return !(before[s][seam.from] + seam.resource + behind[s + 1][seam.to] <=
               most);
    };
    seams.erase(std::remove_if(seams.begin(), seams.end(), useless),
                seams.end());
  }
  return trellis;
}

}  // namespace kg_planner
