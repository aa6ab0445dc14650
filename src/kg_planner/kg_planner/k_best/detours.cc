#include "kg_planner/k_best/detours.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "kg_planner/k_best/no_value.h"

namespace kg_planner {
namespace {

constexpr std::size_t kKeptNodes = 12;  // Nodes kept per stage.

// Reachable nodes with the largest max-marginals, ascending.
std::vector<int> NodesToKeep(const MaxMarginals& marginals, std::size_t s,
                             int count) {
  std::vector<int> nodes;
  for (int v = 0; v < count; ++v) {
    if (marginals.Score(s, v) > kNone) nodes.push_back(v);
  }
  const std::size_t kept = std::min(nodes.size(), kKeptNodes);
  std::partial_sort(nodes.begin(), nodes.begin() + kept, nodes.end(),
                    [&](int a, int b) {
                      const double more = marginals.Score(s, a);
                      const double less = marginals.Score(s, b);
                      return more != less ? more > less : a < b;
                    });
  nodes.resize(kept);
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

}  // namespace

DetourSearch::DetourSearch(const SearchTrellis& search, const ScoreGrid& grid,
                           const Prices& prices, const MaxMarginals& marginals)
    : search_(search), stages_(search.stages.size()) {
  for (std::size_t s = 0; s < stages_.size(); ++s) {
    stages_[s].nodes = NodesToKeep(marginals, s, search.stages[s].nodes);
    stages_[s].times_taken.assign(stages_[s].nodes.size(), 0);
    AddSeams(grid, prices, s);
  }
}

void DetourSearch::AddSeams(const ScoreGrid& grid, const Prices& prices,
                            std::size_t s) {
  const SearchStage& stage = search_.stages[s];
  KeptStage& kept = stages_[s];
  std::vector<int> place(stage.nodes, -1);
  for (std::size_t v = 0; v < kept.nodes.size(); ++v) {
    place[kept.nodes[v]] = static_cast<int>(v);
  }
  // Before the first stage there is only the start, node 0.
  const std::vector<int> start{0};
  const std::vector<int>& before = s == 0 ? start : stages_[s - 1].nodes;
  const Seam* end = stage.seams + stage.seam_count;
  for (std::size_t u = 0; u < before.size(); ++u) {
    // Seams are sorted by `from`: those of a kept node are one range.
    const Seam* seam =
        std::lower_bound(stage.seams, end, before[u],
                         [](const Seam& a, int from) { return a.from < from; });
    for (; seam != end && seam->from == before[u]; ++seam) {
      if (place[seam->to] < 0) continue;
      const int i = static_cast<int>(seam - stage.seams);
      kept.seams.push_back(
          {static_cast<int>(u), place[seam->to], i,
           stage.Gain(i) - PricedCost(stage, i, grid, prices)});
    }
  }
}

void DetourSearch::CountPath(const std::vector<int>& nodes) {
  for (std::size_t s = 0; s < stages_.size(); ++s) {
    KeptStage& kept = stages_[s];
    for (std::size_t v = 0; v < kept.nodes.size(); ++v) {
      if (search_.stages[s].OriginNode(kept.nodes[v]) == nodes[s]) {
        ++kept.times_taken[v];
      }
    }
  }
}

std::vector<int> DetourSearch::Best(double penalty) const {
  // Forward Viterbi pass over the kept seams. The penalty is added after the
  // best seam into a node is chosen; it does not affect that choice.
  // Best kept seam into each node.
  std::vector<std::vector<int>> into(stages_.size());
  std::vector<double> best{0.0};
  for (std::size_t s = 0; s < stages_.size(); ++s) {
    const KeptStage& kept = stages_[s];
    std::vector<double> next(kept.nodes.size(), kNone);
    into[s].assign(kept.nodes.size(), -1);
    for (std::size_t i = 0; i < kept.seams.size(); ++i) {
      const KeptSeam& seam = kept.seams[i];
      const double score = best[seam.from] + seam.weight;
      if (!(score > next[seam.to])) continue;
      next[seam.to] = score;
      into[s][seam.to] = static_cast<int>(i);
    }
    for (std::size_t v = 0; v < next.size(); ++v) {
      next[v] -= penalty * kept.times_taken[v];
    }
    best = std::move(next);
  }
  const auto max_value = std::max_element(best.begin(), best.end());
  if (max_value == best.end() || !(*max_value > kNone)) return {};
  // Trace back from the best last node.
  int node = static_cast<int>(max_value - best.begin());
  std::vector<int> seams(stages_.size());
  for (std::size_t s = stages_.size(); s-- > 0;) {
    const KeptSeam& seam = stages_[s].seams[into[s][node]];
    seams[s] = seam.seam;
    node = seam.from;
  }
  return seams;
}

}  // namespace kg_planner
