#include "kg_planner/k_best/max_marginals.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "kg_planner/k_best/no_value.h"

namespace kg_planner {
MaxMarginals::MaxMarginals(const SearchTrellis& search, const ScoreGrid& grid,
                           const Prices& prices,
                           const std::vector<ViterbiLevel>& levels)
    : search_(search) {
  const std::size_t stages = search.stages.size();
  levels_.resize(stages + 1);
  first_seam_.resize(stages);
  for (std::size_t s = 0; s <= stages; ++s) {
    Level& level = levels_[s];
    const int nodes = search.NodesBefore(s);
    level.before.assign(nodes, s == 0 ? 0.0 : kNone);
    level.behind.assign(nodes, s == stages ? 0.0 : kNone);
    for (auto* seams : {&level.seam_into, &level.node_before, &level.seam_on,
                        &level.node_behind}) {
      seams->assign(nodes, -1);
    }
    level.closed.assign(nodes, 0);
  }
  // Backward pass, unless the caller has its result.
  std::vector<double> weights;
  for (std::size_t s = stages; s-- > 0 && levels.empty();) {
    Weigh(search.stages[s], grid, prices, &weights);
    RelaxBackward(weights, s);
  }
  for (std::size_t s = 0; s < stages && !levels.empty(); ++s) {
    levels_[s].behind = levels[s].best;
    first_seam_[s] = levels[s].first_seam;
  }
  // Forward pass, visiting nodes in the order of ties.
  std::vector<int> order{0};
  for (std::size_t s = 0; s < stages; ++s) {
    Weigh(search.stages[s], grid, prices, &weights);
    if (!levels.empty()) FindSeamsOn(weights, s);
    RelaxForward(weights, order, s);
    order = OrderOfTies(s, order);
  }
}

// Ties: the first seam; seams from one node are in the order of ties.
void MaxMarginals::RelaxBackward(const std::vector<double>& weights,
                                 std::size_t s) {
  const SearchStage& stage = search_.stages[s];
  const std::vector<double>& behind = levels_[s + 1].behind;
  Level& level = levels_[s];
  const int nodes = search_.NodesBefore(s);
  int i = 0;
  for (int u = 0; u < nodes; ++u) {
    first_seam_[s].push_back(i);
    double max_value = kNone;
    int best = -1;
    for (; i < stage.seam_count && stage.seams[i].from == u; ++i) {
      const double score = behind[stage.seams[i].to] + weights[i];
      // Not >=: of equal scores the first seam stays.
      if (!(score > max_value)) continue;
      max_value = score;
      best = i;
    }
    level.behind[u] = max_value;
    level.seam_on[u] = best;
    if (best >= 0) level.node_behind[u] = stage.seams[best].to;
  }
  first_seam_[s].push_back(i);
}

void MaxMarginals::FindSeamsOn(const std::vector<double>& weights,
                               std::size_t s) {
  const SearchStage& stage = search_.stages[s];
  const std::vector<double>& behind = levels_[s + 1].behind;
  Level& level = levels_[s];
  for (std::size_t u = 0; u < level.behind.size(); ++u) {
    const double best = level.behind[u];
    if (!(best > kNone)) continue;
    int i = first_seam_[s][u];
    while (behind[stage.seams[i].to] + weights[i] != best) ++i;
    level.seam_on[u] = i;
    level.node_behind[u] = stage.seams[i].to;
  }
}

// Ties: the first in the order of ties, given by `order` for the previous
// nodes.
void MaxMarginals::RelaxForward(const std::vector<double>& weights,
                                const std::vector<int>& order, std::size_t s) {
  const SearchStage& stage = search_.stages[s];
  Level& next = levels_[s + 1];
  for (const int u : order) {
    const double so_far = levels_[s].before[u];
    for (int i = first_seam_[s][u]; i < first_seam_[s][u + 1]; ++i) {
      const int to = stage.seams[i].to;
      const double score = so_far + weights[i];
      if (!(score > next.before[to])) continue;
      next.before[to] = score;
      next.seam_into[to] = i;
      next.node_before[to] = u;
    }
  }
}

// Reachable nodes of the stage, in the order of ties of their best paths.
std::vector<int> MaxMarginals::OrderOfTies(
    std::size_t s, const std::vector<int>& order_before) const {
  const Level& level = levels_[s + 1];
  std::vector<int> rank(search_.NodesBefore(s), 0);
  for (std::size_t i = 0; i < order_before.size(); ++i) {
    rank[order_before[i]] = static_cast<int>(i);
  }
  std::vector<int> order;
  for (int v = 0; v < search_.stages[s].nodes; ++v) {
    if (level.seam_into[v] >= 0) order.push_back(v);
  }
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    const int rank_a = rank[level.node_before[a]];
    const int rank_b = rank[level.node_before[b]];
    if (rank_a != rank_b) return rank_a < rank_b;
    return level.seam_into[a] < level.seam_into[b];
  });
  return order;
}

double MaxMarginals::Score(std::size_t stage, int node) const {
  const Level& level = levels_[stage + 1];
  return level.before[node] + level.behind[node];
}

std::vector<int> MaxMarginals::Seams(std::size_t stage, int node) const {
  std::vector<int> seams(search_.stages.size());
  int v = node;
  for (std::size_t s = stage + 1; s-- > 0;) {
    seams[s] = levels_[s + 1].seam_into[v];
    v = levels_[s + 1].node_before[v];
  }
  v = node;
  for (std::size_t s = stage + 1; s < seams.size(); ++s) {
    seams[s] = levels_[s].seam_on[v];
    v = levels_[s].node_behind[v];
  }
  return seams;
}

// Best paths into nodes form a tree, and so do best suffixes: differences
// accumulate along both.
void MaxMarginals::CloseNear(const std::vector<int>& nodes,
                             int minimum_difference) {
  const std::size_t stages = search_.stages.size();
  const auto differs = [&](std::size_t s, int v) {
    return search_.stages[s].OriginNode(v) != nodes[s] ? 1 : 0;
  };
  // Differing stages on the best suffix of each node.
  std::vector<std::vector<int>> behind(stages + 1);
  behind[stages].assign(search_.NodesBefore(stages), 0);
  for (std::size_t s = stages; s-- > 1;) {
    behind[s].assign(search_.NodesBefore(s), 0);
    for (std::size_t u = 0; u < behind[s].size(); ++u) {
      const int v = levels_[s].node_behind[u];
      if (v >= 0) behind[s][u] = behind[s + 1][v] + differs(s, v);
    }
  }
  // Differing stages on the best path into each node, and the total.
  std::vector<int> before{0};
  for (std::size_t s = 0; s < stages; ++s) {
    Level& level = levels_[s + 1];
    std::vector<int> next(search_.stages[s].nodes, 0);
    for (std::size_t v = 0; v < next.size(); ++v) {
      if (level.node_before[v] < 0) continue;
      next[v] = before[level.node_before[v]] + differs(s, static_cast<int>(v));
      if (next[v] + behind[s + 1][v] < minimum_difference) level.closed[v] = 1;
    }
    before = std::move(next);
  }
}

}  // namespace kg_planner
