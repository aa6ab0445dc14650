#include "kg_planner/k_best/path_enumerator.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "kg_planner/k_best/no_value.h"

namespace kg_planner {
PathEnumerator::PathEnumerator(const SearchTrellis& search,
                               const ScoreGrid& grid, Prices prices,
                               Tables tables)
    : search_(search),
      grid_(grid),
      prices_(std::move(prices)),
      tables_(std::move(tables)) {
  const std::size_t stages = search.stages.size();
  tables_.levels.resize(stages + 1);
  tables_.rests.resize(stages + 1);
  for (std::size_t s = 0; s <= stages; ++s) {
    if (tables_.rests[s].index.empty()) {
      tables_.rests[s].index.assign(search.NodesBefore(s), -1);
    }
  }
  tables_.levels[stages].best.assign(search.NodesBefore(stages), 0.0);
  for (std::size_t s = stages; s-- > 0;) {
    if (tables_.levels[s].best.empty()) RelaxStage(s);
  }
}

// Best suffix from every node before the stage.
void PathEnumerator::RelaxStage(std::size_t s) {
  const SearchStage& stage = search_.stages[s];
  ViterbiLevel& level = tables_.levels[s];
  const int nodes = search_.NodesBefore(s);
  level.best.resize(nodes);
  level.first_seam.resize(nodes + 1);
  int i = 0;
  for (int u = 0; u < nodes; ++u) {
    level.first_seam[u] = i;
    double max_value = kNone;
    for (; i < stage.seam_count && stage.seams[i].from == u; ++i) {
      max_value = std::max(max_value, ScoreOver(s, i));
    }
    level.best[u] = max_value;
  }
  level.first_seam[nodes] = i;
}

bool PathEnumerator::Worse(const Rest& a, const Rest& b) {
  if (a.score != b.score) return a.score < b.score;
  if (a.seam != b.seam) return a.seam > b.seam;
  return a.rank > b.rank;
}

// Suffixes of a node, starting with the best one if it exists; ties to the
// first seam.
PathEnumerator::NodeRests* PathEnumerator::Rests(std::size_t s, int node) {
  const ViterbiLevel& level = tables_.levels[s];
  LevelRests& made = tables_.rests[s];
  int& index = made.index[node];
  if (index >= 0) return &made.pool[index];
  index = static_cast<int>(made.pool.size());
  NodeRests& rests = made.pool.emplace_back();
  const double best = level.best[node];
  if (!(best > kNone)) return &rests;
  rests.best.push_back({best, -1, 0});
  if (s == search_.stages.size()) return &rests;
  int seam = level.first_seam[node];
  while (ScoreOver(s, seam) != best) ++seam;
  rests.best.front().seam = seam;
  return &rests;
}

const PathEnumerator::Rest* PathEnumerator::Get(std::size_t s, int node,
                                                int rank) {
  NodeRests& rests = *Rests(s, node);
  while (static_cast<int>(rests.best.size()) <= rank) {
    if (rests.best.empty() || s == search_.stages.size()) return nullptr;
    if (!rests.expanded) Expand(s, node, &rests);
    PushNext(s, &rests);
    if (rests.heap.empty()) return nullptr;
    std::pop_heap(rests.heap.begin(), rests.heap.end(), Worse);
    rests.best.push_back(rests.heap.back());
    rests.heap.pop_back();
  }
  return &rests.best[rank];
}

// Adds the best suffix over every seam except that of the overall best.
void PathEnumerator::Expand(std::size_t s, int node, NodeRests* rests) {
  const int taken = rests->best.front().seam;
  const int end = tables_.levels[s].first_seam[node + 1];
  const int begin = tables_.levels[s].first_seam[node];
  rests->heap.reserve(end - begin);
  for (int i = begin; i < end; ++i) {
    const double score = ScoreOver(s, i);
    if (i != taken && score > kNone) rests->heap.push_back({score, i, 0});
  }
  std::make_heap(rests->heap.begin(), rests->heap.end(), Worse);
  rests->expanded = true;
}

// Adds the successor of the last suffix over the same seam. Called once per
// rank: only when the last one of `best` is new.
void PathEnumerator::PushNext(std::size_t s, NodeRests* rests) {
  const Rest last = rests->best.back();
  const SearchStage& stage = search_.stages[s];
  const int to = stage.seams[last.seam].to;
  const Rest* next = Get(s + 1, to, last.rank + 1);
  if (next == nullptr) return;
  rests->heap.push_back(
      {next->score + Weight(stage, last.seam), last.seam, last.rank + 1});
  std::push_heap(rests->heap.begin(), rests->heap.end(), Worse);
}

std::optional<PathEnumerator::BoundedPath> PathEnumerator::Next() {
  const Rest* rest = Get(0, 0, next_rank_);
  if (rest == nullptr) return std::nullopt;
  ++next_rank_;
  BoundedPath path;
  path.bound = rest->score;
  for (std::size_t s = 0; s < search_.stages.size(); ++s) {
    path.seams.push_back(rest->seam);
    rest = Get(s + 1, search_.stages[s].seams[rest->seam].to, rest->rank);
  }
  return path;
}

}  // namespace kg_planner
