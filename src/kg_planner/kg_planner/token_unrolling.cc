#include "kg_planner/token_unrolling.h"

#include <algorithm>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

#include "kg_planner/path_enumerator.h"

namespace kg_planner {
namespace {

// What a path has of each unrolled token; infinity = nothing more to gain.
using Earned = std::vector<double>;
constexpr double kSaturated = std::numeric_limits<double>::infinity();

// Rewards of the unrolled tokens, rounded, by place in the list of tokens.
struct Offers {
  std::vector<std::vector<Earned>> by_node;  // Stage, node.
  std::vector<Earned> best_later;            // Best behind a stage.
};

std::map<int, std::size_t> Places(const std::vector<int>& tokens) {
  std::map<int, std::size_t> places;
  for (std::size_t i = 0; i < tokens.size(); ++i) places[tokens[i]] = i;
  return places;
}

void RaiseTo(const Earned& offer, Earned* best) {
  for (std::size_t i = 0; i < offer.size(); ++i)
    (*best)[i] = std::max((*best)[i], offer[i]);
}

Offers FindOffers(const Trellis& trellis, const std::vector<int>& tokens,
                  const ScoreGrid& grid) {
  const std::map<int, std::size_t> places = Places(tokens);
  Offers offers;
  offers.by_node.resize(trellis.stages.size());
  offers.best_later.resize(trellis.stages.size());
  Earned later(tokens.size(), 0.0);
  for (std::size_t s = trellis.stages.size(); s-- > 0;) {
    offers.best_later[s] = later;
    for (const Node& node : trellis.stages[s].nodes) {
      Earned offer(tokens.size(), 0.0);
      for (const TokenReward& token : DistinctTokens(node)) {
        const auto place = places.find(token.token);
        if (place != places.end())
          offer[place->second] = grid.Round(token.reward);
      }
      RaiseTo(offer, &later);
      offers.by_node[s].push_back(std::move(offer));
    }
  }
  return offers;
}

Node WithoutTokens(const Node& node, const std::map<int, std::size_t>& places,
                   const ScoreGrid& grid) {
  Node rest;
  rest.reward = grid.Round(node.reward);
  for (const TokenReward& token : node.tokens)
    if (places.count(token.token) == 0) rest.tokens.push_back(token);
  return rest;
}

struct Step {
  double gain = 0.0;
  Earned earned;
};

Step Visit(const Earned& before, const Earned& offer, const Earned& later) {
  Step step{0.0, before};
  for (std::size_t i = 0; i < before.size(); ++i) {
    step.gain += std::max(0.0, offer[i] - before[i]);
    step.earned[i] = std::max(before[i], offer[i]);
    if (step.earned[i] >= later[i]) step.earned[i] = kSaturated;
  }
  return step;
}

// The split nodes of one stage while they are being made.
class StageUnroller {
 public:
  // By node, gain, earned: ascending node first keeps paths' order.
  using Key = std::tuple<int, double, Earned>;

  StageUnroller(const Stage& stage, std::vector<Earned> states)
      : states_(std::move(states)),
        target_(states_.size(), std::vector<int>(stage.nodes.size(), -1)) {}

  void Reach(std::size_t state, int node, const Earned& offer,
             const Earned& later) {
    if (target_[state][node] >= 0) return;
    Step step = Visit(states_[state], offer, later);
    const Key key(node, step.gain, std::move(step.earned));
    const auto place =
        place_.emplace(key, static_cast<int>(place_.size())).first;
    target_[state][node] = place->second;
  }

  // Numbers split nodes by key; call when all are reached.
  std::vector<Key> Finish() {
    std::vector<Key> keys;
    std::vector<int> number(place_.size());
    for (const auto& [key, place] : place_) {
      number[place] = static_cast<int>(keys.size());
      keys.push_back(key);
    }
    for (std::vector<int>& row : target_)
      for (int& target : row)
        if (target >= 0) target = number[target];
    return keys;
  }

  int target(std::size_t state, int node) const { return target_[state][node]; }

 private:
  std::vector<Earned> states_;
  std::vector<std::vector<int>> target_;  // By state, node.
  std::map<Key, int> place_;
};

// Split nodes of the stage before: which node, and which of the states.
struct Front {
  std::vector<int> origin;
  std::vector<std::size_t> state;
  std::vector<Earned> states;
};

Front FrontOf(const std::vector<StageUnroller::Key>& keys) {
  std::map<Earned, std::size_t> known;
  Front front;
  for (const auto& [node, gain, earned] : keys) {
    const auto place = known.emplace(earned, known.size());
    if (place.second) front.states.push_back(earned);
    front.origin.push_back(node);
    front.state.push_back(place.first->second);
  }
  return front;
}

// Where the seams of each node begin; they ascend by `from`.
std::vector<std::size_t> FirstSeams(const std::vector<Seam>& seams) {
  const int nodes = seams.empty() ? 0 : seams.back().from + 1;
  std::vector<std::size_t> first(nodes + 1, seams.size());
  for (std::size_t i = seams.size(); i-- > 0;) first[seams[i].from] = i;
  for (std::size_t v = first.size() - 1; v-- > 0;)
    first[v] = std::min(first[v], first[v + 1]);
  return first;
}

template <typename Function>
void ForEachSeam(const std::vector<Seam>& seams, const Front& front,
                 const Function& function) {
  const std::vector<std::size_t> first = FirstSeams(seams);
  for (std::size_t u = 0; u < front.origin.size(); ++u) {
    const std::size_t node = front.origin[u];
    if (node + 1 >= first.size()) continue;
    for (std::size_t i = first[node]; i < first[node + 1]; ++i)
      function(static_cast<int>(u), seams[i]);
  }
}

}  // namespace

std::vector<int> RepeatedTokens(const Trellis& trellis) {
  struct Sum {
    double total = 0.0;
    double best = 0.0;
    double excess() const { return total - best; }
  };
  std::map<int, Sum> sums;
  for (const Stage& stage : trellis.stages) {
    std::map<int, double> best;
    for (const Node& node : stage.nodes)
      for (const TokenReward& token : node.tokens)
        best[token.token] = std::max(best[token.token], token.reward);
    for (const auto& [token, reward] : best) {
      sums[token].total += reward;
      sums[token].best = std::max(sums[token].best, reward);
    }
  }
  std::vector<int> tokens;
  for (const auto& [token, sum] : sums)
    if (sum.excess() > 0.0) tokens.push_back(token);
  std::stable_sort(tokens.begin(), tokens.end(), [&](int a, int b) {
    return sums[a].excess() > sums[b].excess();
  });
  return tokens;
}

std::optional<Unrolled> UnrollTokens(const Trellis& trellis,
                                     const std::vector<int>& tokens,
                                     const ScoreGrid& grid,
                                     std::size_t max_seams) {
  const std::map<int, std::size_t> places = Places(tokens);
  const Offers offers = FindOffers(trellis, tokens, grid);
  Unrolled unrolled;
  unrolled.trellis.resource_limit = trellis.resource_limit;
  Front front{{0}, {0}, {Earned(tokens.size(), 0.0)}};
  std::size_t seams_made = 0;
  for (std::size_t s = 0; s < trellis.stages.size(); ++s) {
    const Stage& stage = trellis.stages[s];
    StageUnroller unroller(stage, front.states);
    ForEachSeam(stage.seams, front, [&](int from, const Seam& seam) {
      if (++seams_made > max_seams) return;
      unroller.Reach(front.state[from], seam.to, offers.by_node[s][seam.to],
                     offers.best_later[s]);
    });
    if (seams_made > max_seams) return std::nullopt;
    const std::vector<StageUnroller::Key> keys = unroller.Finish();
    Stage& split = unrolled.trellis.stages.emplace_back();
    for (const StageUnroller::Key& key : keys) {
      split.nodes.push_back(
          WithoutTokens(stage.nodes[std::get<0>(key)], places, grid));
      split.nodes.back().reward += std::get<1>(key);
    }
    ForEachSeam(stage.seams, front, [&](int from, const Seam& seam) {
      split.seams.push_back({from, unroller.target(front.state[from], seam.to),
                             seam.cost, seam.resource});
    });
    front = FrontOf(keys);
    unrolled.origin.push_back(front.origin);
  }
  return unrolled;
}

}  // namespace kg_planner
