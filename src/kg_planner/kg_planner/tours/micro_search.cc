#include "kg_planner/tours/micro_search.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <random>
#include <utility>

namespace kg_planner {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kPoolPerEnd = 24;  // Pool size per end.

class MicroSearch {
 public:
  MicroSearch(const MicroGraph& graph, const MicroPathOptions& options,
              Clock::time_point deadline)
      : graph_(graph),
        options_(options),
        deadline_(deadline),
        prng_(options.seed),
        pools_(graph.size()) {}

  std::vector<MicroPath> Run(std::vector<MicroPath> paths) {
    for (MicroPath& path : paths) Remember(std::move(path));
    std::vector<int> ends;
    for (int end = 0; end < graph_.size(); ++end) {
      if (!pools_[end].empty()) ends.push_back(end);
    }
    for (std::size_t step = 0; !ends.empty() && step < options_.max_steps;
         ++step) {
      if (deadline_ != Clock::time_point::max() && Clock::now() >= deadline_) {
        break;
      }
      Improve(ends[step % ends.size()]);
    }
    return Found();
  }

 private:
  // Reproducible on every machine, unlike std::uniform_int_distribution.
  std::size_t RandomBelow(std::size_t count) {
    return static_cast<std::size_t>(
        (static_cast<std::uint64_t>(prng_()) * count) >> 32);
  }

  void Remember(MicroPath path) {
    std::vector<int> set = path.nodes;
    std::sort(set.begin(), set.end());
    auto& pool = pools_[path.nodes.back()];
    const auto at = pool.find(set);
    if (at == pool.end()) {
      pool.emplace(std::move(set), std::move(path));
      if (pool.size() > kPoolPerEnd) DropWorst(&pool);
    } else if (BetterOrder(path, at->second)) {
      at->second = std::move(path);
    }
  }

  using Pool = std::map<std::vector<int>, MicroPath>;  // Path by node set.

  // Never drops a path of one node, the direct leg.
  static void DropWorst(Pool* pool) {
    auto worst = pool->end();
    for (auto it = pool->begin(); it != pool->end(); ++it) {
      if (it->first.size() == 1) continue;
      if (worst == pool->end() || it->second.score() < worst->second.score()) {
        worst = it;
      }
    }
    pool->erase(worst);
  }

  void Improve(int end) {
    std::vector<int> nodes = Start(end);
    Repair(&nodes);
    MicroPath path = graph_.Walk(nodes);
    if (!path.nodes.empty()) Remember(std::move(path));
  }

  // Start path: one to this end with a gap, or one to another end extended to
  // this one.
  std::vector<int> Start(int end) {
    const std::size_t other = RandomBelow(2 * pools_.size());
    const bool extend_other = other < pools_.size() && !pools_[other].empty();
    const Pool& pool =
        pools_[extend_other ? other : static_cast<std::size_t>(end)];
    auto start = pool.begin();
    std::advance(start, RandomBelow(pool.size()));
    std::vector<int> nodes = start->second.nodes;
    if (!extend_other) {
      Destroy(&nodes);
      return nodes;
    }
    nodes.erase(std::remove(nodes.begin(), nodes.end(), end), nodes.end());
    if (static_cast<int>(nodes.size()) == options_.max_nodes) nodes.pop_back();
    nodes.push_back(end);
    return nodes;
  }

  // Removes a run of nodes, never the end; keeps the order of the rest.
  void Destroy(std::vector<int>* nodes) {
    if (nodes->size() < 2) return;
    const std::size_t begin = RandomBelow(nodes->size() - 1);
    const std::size_t count =
        1 + RandomBelow(std::min<std::size_t>(3, nodes->size() - 1 - begin));
    nodes->erase(nodes->begin() + begin, nodes->begin() + begin + count);
  }

  struct Insertion {
    int node = -1;
    std::size_t at = 0;
    double rate = 0.0;
  };

  // Greedy insertion by randomised gain per duration while a node has a
  // positive gain and fits; then reorders.
  void Repair(std::vector<int>* nodes) {
    MicroPath path = graph_.Walk(*nodes);
    if (path.nodes.empty()) return;
    while (static_cast<int>(nodes->size()) < options_.max_nodes) {
      const Insertion best = BestInsertion(path);
      if (best.node < 0) break;
      nodes->insert(nodes->begin() + best.at, best.node);
      path = graph_.Walk(*nodes);
      Reorder(&path);
      *nodes = path.nodes;
    }
  }

  Insertion BestInsertion(const MicroPath& path) {
    Insertion best;
    std::vector<int> set = path.nodes;
    std::sort(set.begin(), set.end());
    for (int node = 0; node < graph_.size(); ++node) {
      const auto place = std::lower_bound(set.begin(), set.end(), node);
      if (place != set.end() && *place == node) continue;
      std::vector<int> larger = set;
      larger.insert(larger.begin() + (place - set.begin()), node);
      const double gain = graph_.TotalReward(larger) - path.reward;
      Consider(path, node, gain, &best);
    }
    return best;
  }

  void Consider(const MicroPath& path, int node, double gain, Insertion* best) {
    for (std::size_t at = 0; at < path.nodes.size(); ++at) {
      const int before = at == 0 ? -1 : path.nodes[at - 1];
      const Leg* in = graph_.Find(before, node);
      const Leg* out = graph_.Find(node, path.nodes[at]);
      const Leg* old = graph_.Find(before, path.nodes[at]);
      if (in == nullptr || out == nullptr || old == nullptr) continue;
      const double net = gain - (in->cost + out->cost - old->cost);
      const double longer = in->duration + out->duration - old->duration;
      if (!(path.duration + longer <= graph_.duration_limit())) continue;
      if (!(net > 0.0)) continue;
      const double blur = 0.5 + static_cast<double>(RandomBelow(1024)) / 1024.0;
      const double rate =
          blur * net / (std::max(longer, 0.0) + MinimumDuration());
      if (rate > best->rate) *best = {node, at, rate};
    }
  }

  // Smallest duration used in rates: keeps them finite.
  double MinimumDuration() const {
    return std::isfinite(graph_.duration_limit())
               ? 1e-3 * graph_.duration_limit() + 1e-12
               : 1.0;
  }

  // Local search: reverses runs and moves single nodes, with the end fixed,
  // while that improves the path.
  void Reorder(MicroPath* path) const {
    bool better = true;
    while (better) better = ReorderOnce(path);
  }
  bool ReorderOnce(MicroPath* path) const {
    const std::size_t last = path->nodes.size() - 1;
    for (std::size_t i = 0; i < last; ++i) {
      for (std::size_t j = i + 1; j < last; ++j) {
        // Three moves: reverse [i, j], move i behind j, move j before i.
        std::vector<int> reversed = path->nodes;
        std::reverse(reversed.begin() + i, reversed.begin() + j + 1);
        std::vector<int> later = path->nodes;
        std::rotate(later.begin() + i, later.begin() + i + 1,
                    later.begin() + j + 1);
        std::vector<int> sooner = path->nodes;
        std::rotate(sooner.begin() + i, sooner.begin() + j,
                    sooner.begin() + j + 1);
        for (const auto* nodes : {&reversed, &later, &sooner}) {
          const MicroPath other = graph_.Walk(*nodes);
          if (other.nodes.empty() || !Shorter(other, *path)) continue;
          *path = other;
          return true;
        }
      }
    }
    return false;
  }
  static bool Shorter(const MicroPath& a, const MicroPath& b) {
    return a.cost < b.cost || (a.cost == b.cost && a.duration < b.duration);
  }

  std::vector<MicroPath> Found() {
    std::vector<MicroPath> paths;
    for (Pool& pool : pools_) {
      for (auto& [set, path] : pool) paths.push_back(std::move(path));
    }
    return paths;
  }

  const MicroGraph& graph_;
  const MicroPathOptions& options_;
  const Clock::time_point deadline_;
  std::mt19937 prng_;
  std::vector<Pool> pools_;  // Pool of each end.
};

}  // namespace

std::vector<MicroPath> ImproveMicroPaths(const MicroGraph& graph,
                                         std::vector<MicroPath> paths,
                                         const MicroPathOptions& options,
                                         Clock::time_point deadline) {
  return MicroSearch(graph, options, deadline).Run(std::move(paths));
}

}  // namespace kg_planner
