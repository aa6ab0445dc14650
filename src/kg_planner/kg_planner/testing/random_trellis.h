// Small random trellises and exhaustive enumeration of their paths: the
// reference for the tests of this package.

#ifndef KG_PLANNER_TESTING_RANDOM_TRELLIS_H_
#define KG_PLANNER_TESTING_RANDOM_TRELLIS_H_

#include <algorithm>
#include <limits>
#include <map>
#include <random>
#include <vector>

#include "kg_planner/k_best/k_best.h"
#include "kg_planner/trellis/trellis.h"

namespace kg_planner {

struct RandomOptions {
  bool whole_numbers = false;  // Integer values: many ties.
  bool tokens = false;
  bool limited = false;
  bool masked = false;
  double missing = 0.2;  // Share of missing seams.
  int max_stages = 5;
  int max_nodes = 5;
  bool stops = false;      // Seams with stops on the way, hence parallel ones.
  int more_resources = 0;  // Further resources; limited if `limited`.
};

class RandomTrellis {
 public:
  RandomTrellis(const RandomOptions& options, unsigned seed)
      : options_(options), prng_(seed) {}

  Trellis Make() {
    Trellis trellis;
    trellis.stages.resize(Whole(1, options_.max_stages));
    int before = 1;
    for (Stage& stage : trellis.stages) {
      stage.nodes.resize(Whole(Whole(0, 19) == 0 ? 0 : 1, options_.max_nodes));
      for (Node& node : stage.nodes) node = MakeNode();
      AddSeams(before, &stage);
      before = static_cast<int>(stage.nodes.size());
    }
    if (options_.limited) {
      trellis.resource_limit = trellis.stages.size() * Number(1.0, 6.0);
    }
    for (int r = 0; r < options_.more_resources; ++r) {
      trellis.more_limits.push_back(
          options_.limited && Whole(0, 4) > 0
              ? trellis.stages.size() * Number(1.0, 6.0)
              : std::numeric_limits<double>::infinity());
    }
    return trellis;
  }

  PathMasks MakeMasks(const Trellis& trellis) {
    PathMasks masks;
    if (!options_.masked) return masks;
    for (int s = 0; s < static_cast<int>(trellis.stages.size()); ++s) {
      const Stage& stage = trellis.stages[s];
      if (!stage.nodes.empty() && Whole(0, 2) == 0) {
        masks.nodes.push_back(
            {s, Whole(0, static_cast<int>(stage.nodes.size()) - 1)});
      }
      for (std::size_t i = 0; i < stage.seams.size(); ++i) {
        if (Whole(0, 9) > 0) continue;
        const Seam& seam = stage.seams[i];
        masks.seams.push_back({s, seam.from, seam.to});
        if (!stage.via.empty()) masks.seams.back().via = stage.via[i];
      }
    }
    return masks;
  }

  int Whole(int low, int high) {
    return std::uniform_int_distribution<int>(low, high)(prng_);
  }

 private:
  double Number(double low, double high) {
    if (options_.whole_numbers) {
      return Whole(static_cast<int>(low), static_cast<int>(high));
    }
    return std::uniform_real_distribution<double>(low, high)(prng_);
  }
  Node MakeNode() {
    Node node;
    node.reward = Number(-2.0, 5.0);
    for (int i = options_.tokens ? Whole(0, 2) : 0; i > 0; --i) {
      node.tokens.push_back({Whole(-1, 2), Number(0.0, 6.0)});
    }
    return node;
  }
  void AddSeams(int before, Stage* stage) {
    std::bernoulli_distribution missing(options_.missing);
    for (int u = 0; u < before; ++u) {
      for (int v = 0; v < static_cast<int>(stage->nodes.size()); ++v) {
        if (!missing(prng_)) {
          stage->seams.push_back({u, v, Number(0.0, 3.0), Number(0.0, 6.0)});
        }
      }
    }
    if (options_.stops && Whole(0, 3) > 0) AddStops(stage);
    if (Whole(0, 1) == 0) Shuffle(stage);
    for (int r = 0; r < options_.more_resources; ++r) {
      auto& resource = stage->more_resources.emplace_back();
      for (std::size_t i = 0; i < stage->seams.size(); ++i) {
        resource.push_back(Number(0.0, 6.0));
      }
    }
  }
  // Adds seams via one or more other nodes, parallel to some direct seams.
  void AddStops(Stage* stage) {
    const std::size_t direct = stage->seams.size();
    stage->via.resize(direct);
    for (std::size_t i = 0; i < direct; ++i) {
      for (int more = Whole(0, 2); more > 0; --more) {
        Seam seam = stage->seams[i];
        seam.cost = Number(0.0, 3.0);
        seam.resource = Number(0.0, 6.0);
        std::vector<int> via;
        for (int v = 0; v < static_cast<int>(stage->nodes.size()); ++v) {
          if (v != seam.to && Whole(0, 1) == 0) via.push_back(v);
        }
        std::shuffle(via.begin(), via.end(), prng_);
        if (Known(*stage, seam, via)) continue;
        stage->seams.push_back(seam);
        stage->via.push_back(via);
      }
    }
  }
  static bool Known(const Stage& stage, const Seam& seam,
                    const std::vector<int>& via) {
    for (std::size_t i = 0; i < stage.seams.size(); ++i) {
      if (stage.seams[i].from == seam.from && stage.seams[i].to == seam.to &&
          stage.via[i] == via) {
        return true;
      }
    }
    return false;
  }
  void Shuffle(Stage* stage) {
    std::vector<std::size_t> order(stage->seams.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::shuffle(order.begin(), order.end(), prng_);
    Stage shuffled;
    for (const std::size_t i : order) {
      shuffled.seams.push_back(stage->seams[i]);
      if (!stage->via.empty()) shuffled.via.push_back(stage->via[i]);
    }
    stage->seams = shuffled.seams;
    stage->via = shuffled.via;
  }

  RandomOptions options_;
  std::mt19937 prng_;
};

// All allowed paths, best first; ties stage by stage by node, then via.
class ExhaustiveSearch {
 public:
  ExhaustiveSearch(const Trellis& trellis, const PathMasks& masks)
      : trellis_(trellis), masks_(masks) {
    if (!trellis.stages.empty()) Extend({}, 0);
    std::stable_sort(paths_.begin(), paths_.end(),
                     [this](const Path& a, const Path& b) {
                       if (a.score() != b.score()) return a.score() > b.score();
                       return Visited(a) < Visited(b);
                     });
  }
  const std::vector<Path>& paths() const { return paths_; }

 private:
  std::vector<int> NodesVia(std::size_t stage, int seam) const {
    const auto& via = trellis_.stages[stage].via;
    return via.empty() ? std::vector<int>() : via[seam];
  }
  // Visited nodes by stage: the node, then the stops.
  std::vector<std::vector<int>> Visited(const Path& path) const {
    std::vector<std::vector<int>> visited;
    for (std::size_t s = 0; s < path.nodes.size(); ++s) {
      visited.push_back({path.nodes[s]});
      for (const int node : NodesVia(s, path.seams[s])) {
        visited.back().push_back(node);
      }
    }
    return visited;
  }
  bool Masked(int stage, int index) const {
    const Seam& seam = trellis_.stages[stage].seams[index];
    std::vector<int> visited = NodesVia(stage, index);
    for (const SeamMask& mask : masks_.seams) {
      if (mask.stage == stage && mask.from == seam.from && mask.to == seam.to &&
          mask.via == visited) {
        return true;
      }
    }
    visited.push_back(seam.to);
    for (const NodeMask& mask : masks_.nodes) {
      if (mask.stage == stage &&
          std::count(visited.begin(), visited.end(), mask.node) > 0) {
        return true;
      }
    }
    return false;
  }
  void Extend(const std::vector<int>& path, int at) {
    const int stage = static_cast<int>(path.size());
    if (path.size() == trellis_.stages.size()) return Add(path);
    const auto& seams = trellis_.stages[stage].seams;
    for (std::size_t i = 0; i < seams.size(); ++i) {
      if (seams[i].from != at || Masked(stage, i)) continue;
      std::vector<int> longer = path;
      longer.push_back(static_cast<int>(i));
      Extend(longer, seams[i].to);
    }
  }
  void Add(const std::vector<int>& seams) {
    Path path;
    path.seams = seams;
    path.more_resources.resize(trellis_.more_limits.size());
    std::map<int, double> tokens;
    for (std::size_t s = 0; s < seams.size(); ++s) {
      const Stage& stage = trellis_.stages[s];
      const Seam& seam = stage.seams[seams[s]];
      path.nodes.push_back(seam.to);
      path.cost += seam.cost;
      path.resource += seam.resource;
      for (std::size_t r = 0; r < path.more_resources.size(); ++r) {
        path.more_resources[r] += stage.more_resources[r][seams[s]];
      }
      std::vector<int> visited = NodesVia(s, seams[s]);
      visited.push_back(seam.to);
      for (const int node : visited) {
        path.reward += stage.nodes[node].reward;
        for (const TokenReward& token : stage.nodes[node].tokens) {
          tokens[token.token] = std::max(tokens[token.token], token.reward);
        }
      }
    }
    for (const auto& [token, reward] : tokens) path.reward += reward;
    for (std::size_t r = 0; r < path.more_resources.size(); ++r) {
      if (!(path.more_resources[r] <= trellis_.more_limits[r])) return;
    }
    if (path.resource <= trellis_.resource_limit) paths_.push_back(path);
  }

  const Trellis& trellis_;
  const PathMasks& masks_;
  std::vector<Path> paths_;
};

}  // namespace kg_planner

#endif  // KG_PLANNER_TESTING_RANDOM_TRELLIS_H_
