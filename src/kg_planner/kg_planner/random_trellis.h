// Small random trellises, and all their paths by exhaustion: what the tests of
// this package compare with.

#ifndef KG_PLANNER_RANDOM_TRELLIS_H_
#define KG_PLANNER_RANDOM_TRELLIS_H_

#include <algorithm>
#include <map>
#include <random>
#include <vector>

#include "kg_planner/k_best.h"
#include "kg_planner/trellis.h"

namespace kg_planner {

struct RandomOptions {
  bool whole_numbers = false;  // Many ties.
  bool tokens = false;
  bool limited = false;
  bool masked = false;
  double missing = 0.2;  // Share of seams that are not there.
  int max_stages = 5;
  int max_nodes = 5;
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
    if (options_.limited)
      trellis.resource_limit = trellis.stages.size() * Number(1.0, 6.0);
    return trellis;
  }

  Masks MakeMasks(const Trellis& trellis) {
    Masks masks;
    if (!options_.masked) return masks;
    for (int s = 0; s < static_cast<int>(trellis.stages.size()); ++s) {
      const Stage& stage = trellis.stages[s];
      if (!stage.nodes.empty() && Whole(0, 2) == 0)
        masks.nodes.push_back(
            {s, Whole(0, static_cast<int>(stage.nodes.size()) - 1)});
      for (const Seam& seam : stage.seams)
        if (Whole(0, 9) == 0) masks.seams.push_back({s, seam.from, seam.to});
    }
    return masks;
  }

  int Whole(int low, int high) {
    return std::uniform_int_distribution<int>(low, high)(prng_);
  }

 private:
  double Number(double low, double high) {
    if (options_.whole_numbers)
      return Whole(static_cast<int>(low), static_cast<int>(high));
    return std::uniform_real_distribution<double>(low, high)(prng_);
  }
  Node MakeNode() {
    Node node;
    node.reward = Number(-2.0, 5.0);
    for (int i = options_.tokens ? Whole(0, 2) : 0; i > 0; --i)
      node.tokens.push_back({Whole(-1, 2), Number(0.0, 6.0)});
    return node;
  }
  void AddSeams(int before, Stage* stage) {
    std::bernoulli_distribution missing(options_.missing);
    for (int u = 0; u < before; ++u)
      for (int v = 0; v < static_cast<int>(stage->nodes.size()); ++v)
        if (!missing(prng_))
          stage->seams.push_back({u, v, Number(0.0, 3.0), Number(0.0, 6.0)});
    if (Whole(0, 1) == 0)
      std::shuffle(stage->seams.begin(), stage->seams.end(), prng_);
  }

  RandomOptions options_;
  std::mt19937 prng_;
};

// All allowed paths, best first, the same score by node numbers.
class Exhaustion {
 public:
  Exhaustion(const Trellis& trellis, const Masks& masks)
      : trellis_(trellis), masks_(masks) {
    if (!trellis.stages.empty()) Extend({});
    std::stable_sort(paths_.begin(), paths_.end(),
                     [](const Path& a, const Path& b) {
                       if (a.score() != b.score()) return a.score() > b.score();
                       return a.nodes < b.nodes;
                     });
  }
  const std::vector<Path>& paths() const { return paths_; }

 private:
  bool Masked(int stage, const Seam& seam) const {
    for (const NodeMask& mask : masks_.nodes)
      if (mask.stage == stage && mask.node == seam.to) return true;
    for (const SeamMask& mask : masks_.seams)
      if (mask.stage == stage && mask.from == seam.from && mask.to == seam.to)
        return true;
    return false;
  }
  void Extend(const std::vector<const Seam*>& path) {
    const int stage = static_cast<int>(path.size());
    if (path.size() == trellis_.stages.size()) return Add(path);
    const int at = path.empty() ? 0 : path.back()->to;
    for (const Seam& seam : trellis_.stages[stage].seams) {
      if (seam.from != at || Masked(stage, seam)) continue;
      std::vector<const Seam*> longer = path;
      longer.push_back(&seam);
      Extend(longer);
    }
  }
  void Add(const std::vector<const Seam*>& seams) {
    Path path;
    std::map<int, double> tokens;
    for (std::size_t s = 0; s < seams.size(); ++s) {
      const Node& node = trellis_.stages[s].nodes[seams[s]->to];
      path.nodes.push_back(seams[s]->to);
      path.reward += node.reward;
      path.cost += seams[s]->cost;
      path.resource += seams[s]->resource;
      for (const TokenReward& token : node.tokens)
        tokens[token.token] = std::max(tokens[token.token], token.reward);
    }
    for (const auto& [token, reward] : tokens) path.reward += reward;
    if (path.resource <= trellis_.resource_limit) paths_.push_back(path);
  }

  const Trellis& trellis_;
  const Masks& masks_;
  std::vector<Path> paths_;
};

}  // namespace kg_planner

#endif  // KG_PLANNER_RANDOM_TRELLIS_H_
