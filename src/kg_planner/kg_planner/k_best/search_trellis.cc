#include "kg_planner/k_best/search_trellis.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

#include "kg_planner/trellis/trellis_check.h"

namespace kg_planner {
namespace {

void CheckIndex(const char* what, int index, std::size_t size) {
  if (index >= 0 && static_cast<std::size_t>(index) < size) return;
  throw std::invalid_argument(std::string("mask: ") + what + " " +
                              std::to_string(index) + " of " +
                              std::to_string(size));
}

void CheckMasks(const Trellis& trellis, const PathMasks& masks) {
  const auto& stages = trellis.stages;
  for (const NodeMask& mask : masks.nodes) {
    CheckIndex("stage", mask.stage, stages.size());
    CheckIndex("node", mask.node, stages[mask.stage].nodes.size());
  }
  for (const SeamMask& mask : masks.seams) {
    CheckIndex("stage", mask.stage, stages.size());
    CheckIndex("from", mask.from, NodesBefore(trellis, mask.stage));
    CheckIndex("to", mask.to, stages[mask.stage].nodes.size());
    for (const int node : mask.via) {
      CheckIndex("via", node, stages[mask.stage].nodes.size());
    }
  }
}

using SeamName = std::tuple<int, int, std::vector<int>>;

struct StageMasks {
  std::vector<char> nodes;      // Empty = none.
  std::vector<SeamName> seams;  // Ascending.
};

std::vector<StageMasks> ByStage(const Trellis& trellis,
                                const PathMasks& masks) {
  std::vector<StageMasks> by_stage(trellis.stages.size());
  for (const NodeMask& mask : masks.nodes) {
    by_stage[mask.stage].nodes.resize(trellis.stages[mask.stage].nodes.size());
    by_stage[mask.stage].nodes[mask.node] = 1;
  }
  for (const SeamMask& mask : masks.seams) {
    by_stage[mask.stage].seams.emplace_back(mask.from, mask.to, mask.via);
  }
  for (StageMasks& stage : by_stage) {
    std::sort(stage.seams.begin(), stage.seams.end());
  }
  return by_stage;
}

bool IsForbidden(const Stage& stage, std::size_t i, const StageMasks* before,
                 const StageMasks& here) {
  const Seam& seam = stage.seams[i];
  if (before && !before->nodes.empty() && before->nodes[seam.from]) return true;
  if (!here.nodes.empty()) {
    if (here.nodes[seam.to]) return true;
    for (const int node : NodesVia(stage, i)) {
      if (here.nodes[node]) return true;
    }
  }
  return !here.seams.empty() &&
         std::binary_search(here.seams.begin(), here.seams.end(),
                            SeamName(seam.from, seam.to, NodesVia(stage, i)));
}

// Indices of all seams in the order of ties.
std::vector<int> InOrder(const Stage& stage, bool sorted) {
  std::vector<int> order(stage.seams.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
  if (!sorted) {
    std::sort(order.begin(), order.end(),
              [&](int a, int b) { return StandsBefore(stage, a, b); });
  }
  return order;
}

double Gain(const ScoreGrid& grid, const std::vector<TokenReward>& tokens) {
  double gain = 0.0;
  for (const TokenReward& token : tokens) gain += grid.Round(token.reward);
  return gain;
}

double SeamGain(const ScoreGrid& grid, const Stage& stage, int seam) {
  double gain = grid.Round(stage.nodes[stage.seams[seam].to].reward);
  for (const int node : NodesVia(stage, seam)) {
    gain += grid.Round(stage.nodes[node].reward);
  }
  return gain + Gain(grid, TokensMet(stage, seam));
}

void KeepSome(const std::vector<int>& order, const StageMasks* before,
              const StageMasks& here, SearchStage* search) {
  const Stage& stage = *search->stage;
  for (std::size_t place = 0; place < order.size(); ++place) {
    const int i = order[place];
    if (IsForbidden(stage, i, before, here)) continue;
    search->own.push_back(stage.seams[i]);
    search->origin.push_back(i);
    search->place.push_back(static_cast<int>(place));
  }
  search->UseOwn();
}

}  // namespace

double SearchStage::Resource(int seam, std::size_t r) const {
  return r == 0 ? seams[seam].resource
                : stage->more_resources[r - 1][Origin(seam)];
}

void SearchStage::UseOwn() {
  seams = own.data();
  seam_count = static_cast<int>(own.size());
}

void Weigh(const SearchStage& stage, const ScoreGrid& grid,
           const Prices& prices, std::vector<double>* weights) {
  weights->resize(stage.seam_count);
  double* weight = weights->data();
  if (!stage.seam_gain.empty() || !prices.empty()) {
    for (int i = 0; i < stage.seam_count; ++i) {
      weight[i] = stage.Gain(i) - PricedCost(stage, i, grid, prices);
    }
    return;
  }
  const double* gain = stage.node_gain.data();
  const Seam* seams = stage.seams;
  for (int i = 0; i < stage.seam_count; ++i) {
    weight[i] = gain[seams[i].to] - grid.Round(seams[i].cost);
  }
}

std::vector<double> ResourceLimits(const Trellis& trellis) {
  std::vector<double> limits{trellis.resource_limit};
  limits.insert(limits.end(), trellis.more_limits.begin(),
                trellis.more_limits.end());
  return limits;
}

std::vector<TokenReward> Distinct(std::vector<TokenReward> tokens) {
  std::sort(tokens.begin(), tokens.end(),
            [](const TokenReward& a, const TokenReward& b) {
              if (a.token != b.token) return a.token < b.token;
              return a.reward > b.reward;
            });
  tokens.erase(std::unique(tokens.begin(), tokens.end(),
                           [](const TokenReward& a, const TokenReward& b) {
                             return a.token == b.token;
                           }),
               tokens.end());
  return tokens;
}

std::vector<TokenReward> TokensMet(const Stage& stage, std::size_t i) {
  std::vector<TokenReward> tokens = stage.nodes[stage.seams[i].to].tokens;
  for (const int node : NodesVia(stage, i)) {
    const auto& more = stage.nodes[node].tokens;
    tokens.insert(tokens.end(), more.begin(), more.end());
  }
  return Distinct(std::move(tokens));
}

SearchTrellis ToSearch(const Trellis& trellis, const std::vector<char>& sorted,
                       const PathMasks& masks, const ScoreGrid& grid) {
  CheckMasks(trellis, masks);
  const std::vector<StageMasks> by_stage = ByStage(trellis, masks);
  const bool masked = !masks.nodes.empty() || !masks.seams.empty();
  SearchTrellis search;
  for (std::size_t s = 0; s < trellis.stages.size(); ++s) {
    const Stage& stage = trellis.stages[s];
    SearchStage& made = search.stages.emplace_back();
    made.stage = &stage;
    made.nodes = static_cast<int>(stage.nodes.size());
    made.seams = stage.seams.data();
    made.seam_count = static_cast<int>(stage.seams.size());
    // Seams are copied only where some are dropped or out of order.
    if (masked || !sorted[s]) {
      KeepSome(InOrder(stage, sorted[s]), s > 0 ? &by_stage[s - 1] : nullptr,
               by_stage[s], &made);
    }
    for (const Node& node : stage.nodes) {
      made.node_gain.push_back(grid.Round(node.reward) +
                               Gain(grid, Distinct(node.tokens)));
    }
    // Without stops the gain of a seam is that of its end.
    if (stage.via.empty()) continue;
    for (int i = 0; i < made.seam_count; ++i) {
      made.seam_gain.push_back(SeamGain(grid, stage, made.Origin(i)));
    }
  }
  return search;
}

}  // namespace kg_planner
