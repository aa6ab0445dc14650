#include "kg_planner/path_enumerator.h"

#include <algorithm>
#include <limits>

#include "kg_planner/survey.h"

namespace kg_planner {
namespace {

constexpr double kNone = -std::numeric_limits<double>::infinity();

double Gain(const ScoreGrid& grid, const Node& node) {
  double gain = grid.Round(node.reward);
  if (node.tokens.empty()) return gain;
  for (const TokenReward& token : DistinctTokens(node))
    gain += grid.Round(token.reward);
  return gain;
}

}  // namespace

std::vector<TokenReward> DistinctTokens(const Node& node) {
  std::vector<TokenReward> tokens = node.tokens;
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

PathEnumerator::PathEnumerator(const Trellis& trellis, const ScoreGrid& grid,
                               double price)
    : trellis_(trellis), grid_(grid), price_(price) {
  const std::size_t stages = trellis.stages.size();
  gains_.resize(stages);
  levels_.resize(stages + 1);
  for (std::size_t s = 0; s <= stages; ++s)
    levels_[s].resize(NodesBefore(trellis, s));
  const Rest end;
  for (NodeRests& rests : levels_[stages]) {
    rests.best.push_back(end);
    rests.expanded = true;
  }
  for (std::size_t s = stages; s-- > 0;) RelaxStage(s);
}

// The best rest from every node before the stage; ties to the smallest `to`.
void PathEnumerator::RelaxStage(std::size_t stage) {
  const Stage& next = trellis_.stages[stage];
  std::vector<double>& gains = gains_[stage];
  for (const Node& node : next.nodes) gains.push_back(Gain(grid_, node));
  std::vector<double> onward(gains.size(), kNone);
  for (std::size_t v = 0; v < gains.size(); ++v) {
    const NodeRests& rests = levels_[stage + 1][v];
    if (!rests.best.empty()) onward[v] = gains[v] + rests.best.front().score;
  }
  const int seams = static_cast<int>(next.seams.size());
  int i = 0;
  for (std::size_t u = 0; u < levels_[stage].size(); ++u) {
    NodeRests& rests = levels_[stage][u];
    rests.first_seam = i;
    double most = kNone;
    int best = -1;
    for (; i < seams && next.seams[i].from == static_cast<int>(u); ++i) {
      const Seam& seam = next.seams[i];
      const double score = onward[seam.to] - Price(seam);
      if (score > most) {
        most = score;
        best = i;
      }
    }
    rests.seams_end = i;
    if (best >= 0) rests.best.push_back({most, best, next.seams[best].to, 0});
  }
}

bool PathEnumerator::Worse(const Rest& a, const Rest& b) {
  if (a.score != b.score) return a.score < b.score;
  if (a.to != b.to) return a.to > b.to;
  return a.rank > b.rank;
}

const PathEnumerator::Rest* PathEnumerator::Get(std::size_t level, int node,
                                                int rank) {
  NodeRests& rests = levels_[level][node];
  while (static_cast<int>(rests.best.size()) <= rank) {
    if (rests.best.empty() || level == trellis_.stages.size()) return nullptr;
    if (!rests.expanded) Expand(level, &rests);
    PushNext(level, &rests);
    if (rests.heap.empty()) return nullptr;
    std::pop_heap(rests.heap.begin(), rests.heap.end(), Worse);
    rests.best.push_back(rests.heap.back());
    rests.heap.pop_back();
  }
  return &rests.best[rank];
}

// The best rest over every seam but the one the best of all takes.
void PathEnumerator::Expand(std::size_t level, NodeRests* rests) {
  const Stage& stage = trellis_.stages[level];
  const int taken = rests->best.front().seam;
  for (int i = rests->first_seam; i < rests->seams_end; ++i) {
    const Seam& seam = stage.seams[i];
    const NodeRests& there = levels_[level + 1][seam.to];
    if (i == taken || there.best.empty()) continue;
    rests->heap.push_back(
        {there.best.front().score + Weight(level, seam), i, seam.to, 0});
  }
  std::make_heap(rests->heap.begin(), rests->heap.end(), Worse);
  rests->expanded = true;
}

// What comes after the last one over the same seam. Asked for once per rank:
// Get() calls this only when the last one of `best` is new.
void PathEnumerator::PushNext(std::size_t level, NodeRests* rests) {
  const Rest last = rests->best.back();
  const Rest* next = Get(level + 1, last.to, last.rank + 1);
  if (next == nullptr) return;
  const Seam& seam = trellis_.stages[level].seams[last.seam];
  rests->heap.push_back(
      {next->score + Weight(level, seam), last.seam, last.to, last.rank + 1});
  std::push_heap(rests->heap.begin(), rests->heap.end(), Worse);
}

std::optional<PathEnumerator::BoundedPath> PathEnumerator::Next() {
  const Rest* rest = Get(0, 0, next_rank_);
  if (rest == nullptr) return std::nullopt;
  ++next_rank_;
  BoundedPath path;
  path.bound = rest->score;
  for (std::size_t level = 0; level < trellis_.stages.size(); ++level) {
    path.seams.push_back(rest->seam);
    rest = Get(level + 1, rest->to, rest->rank);
  }
  return path;
}

}  // namespace kg_planner
