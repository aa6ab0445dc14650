#include "kg_planner/k_best/token_unrolling.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include "kg_planner/trellis/trellis_check.h"

namespace kg_planner {
namespace {

// Reward already earned of each unrolled token; infinity = no further gain
// possible.
using Earned = std::vector<double>;
constexpr double kSaturated = std::numeric_limits<double>::infinity();

// Rewards of unrolled tokens offered by the seams of a stage, rounded. Offer v
// belongs to node v; seams with stops have their own offers after those.
struct StageOffers {
  std::vector<Earned> offers;
  std::vector<int> of_seam;
  Earned best_later;  // Best offers in later stages.
};

std::map<int, std::size_t> Places(const std::vector<int>& tokens) {
  std::map<int, std::size_t> places;
  for (std::size_t i = 0; i < tokens.size(); ++i) places[tokens[i]] = i;
  return places;
}

class OfferFinder {
 public:
  OfferFinder(const std::vector<int>& tokens, const ScoreGrid& grid)
      : places_(Places(tokens)), grid_(grid) {}

  StageOffers Find(const SearchStage& search) const {
    StageOffers found;
    for (const Node& node : search.stage->nodes) {
      found.offers.push_back(Offer(Distinct(node.tokens)));
    }
    for (int i = 0; i < search.seam_count; ++i) {
      const std::size_t origin = search.Origin(i);
      found.of_seam.push_back(search.seams[i].to);
      if (NodesVia(*search.stage, origin).empty()) continue;
      found.of_seam.back() = static_cast<int>(found.offers.size());
      found.offers.push_back(Offer(TokensMet(*search.stage, origin)));
    }
    return found;
  }

 private:
  Earned Offer(const std::vector<TokenReward>& tokens) const {
    Earned offer(places_.size(), 0.0);
    for (const TokenReward& token : tokens) {
      const auto place = places_.find(token.token);
      if (place != places_.end()) {
        offer[place->second] = grid_.Round(token.reward);
      }
    }
    return offer;
  }

  std::map<int, std::size_t> places_;
  ScoreGrid grid_;
};

std::vector<StageOffers> FindOffers(const SearchTrellis& search,
                                    const std::vector<int>& tokens,
                                    const ScoreGrid& grid) {
  const OfferFinder finder(tokens, grid);
  std::vector<StageOffers> offers(search.stages.size());
  Earned later(tokens.size(), 0.0);
  for (std::size_t s = search.stages.size(); s-- > 0;) {
    offers[s] = finder.Find(search.stages[s]);
    offers[s].best_later = later;
    for (const Earned& offer : offers[s].offers) {
      for (std::size_t i = 0; i < offer.size(); ++i) {
        later[i] = std::max(later[i], offer[i]);
      }
    }
  }
  return offers;
}

// Builds the split nodes of one stage.
class StageUnroller {
 public:
  using Key = std::pair<int, Earned>;  // (node, rewards earned there)
  struct Target {
    int node = -1;
    double gain = 0.0;  // Gain of unrolled tokens.
  };

  StageUnroller(const StageOffers& offers, std::vector<Earned> states)
      : offers_(offers),
        states_(std::move(states)),
        targets_(states_.size(), std::vector<Target>(offers.offers.size())) {}

  // Target split node of a seam, and its gain.
  Target Reach(std::size_t state, const Seam& seam, int offer) {
    Target& target = targets_[state][offer];
    if (target.node >= 0) return target;
    Key key(seam.to, states_[state]);
    for (std::size_t i = 0; i < key.second.size(); ++i) {
      const double offered = offers_.offers[offer][i];
      target.gain += std::max(0.0, offered - key.second[i]);
      key.second[i] = std::max(key.second[i], offered);
      if (key.second[i] >= offers_.best_later[i]) key.second[i] = kSaturated;
    }
    const auto place = place_.emplace(key, static_cast<int>(keys_.size()));
    if (place.second) keys_.push_back(std::move(key));
    target.node = place.first->second;
    return target;
  }

  const std::vector<Key>& keys() const { return keys_; }

 private:
  const StageOffers& offers_;
  std::vector<Earned> states_;
  std::vector<std::vector<Target>> targets_;  // Indexed by state and offer.
  std::map<Key, int> place_;
  std::vector<Key> keys_;
};

// Split nodes of the previous stage: origin node and state.
struct SplitNodes {
  std::vector<int> origin;
  std::vector<std::size_t> state;
  std::vector<Earned> states;
};

SplitNodes ToSplitNodes(const std::vector<StageUnroller::Key>& keys) {
  std::map<Earned, std::size_t> known;
  SplitNodes split;
  for (const auto& [node, earned] : keys) {
    const auto place = known.emplace(earned, known.size());
    if (place.second) split.states.push_back(earned);
    split.origin.push_back(node);
    split.state.push_back(place.first->second);
  }
  return split;
}

// Index of the first seam of each of `nodes` nodes; seams ascend by `from`.
std::vector<int> FirstSeams(const SearchStage& stage, int nodes) {
  std::vector<int> first(nodes + 1, 0);
  for (int i = 0; i < stage.seam_count; ++i) ++first[stage.seams[i].from + 1];
  for (int v = 0; v < nodes; ++v) first[v + 1] += first[v];
  return first;
}

double Sum(const Earned& offer) {
  double sum = 0.0;
  for (const double reward : offer) sum += reward;
  return sum;
}

// Builds the split stage with the nodes of `unroller`. False if there are too
// many seams.
bool UnrollStage(const SearchStage& stage, const StageOffers& offers,
                 const SplitNodes& split_before, std::size_t max_seams,
                 StageUnroller* unroller, SearchStage* split) {
  // Number of nodes of the previous stage, from split nodes and from seams.
  int nodes = 0;
  for (const int origin : split_before.origin) {
    nodes = std::max(nodes, origin + 1);
  }
  for (int i = 0; i < stage.seam_count; ++i) {
    nodes = std::max(nodes, stage.seams[i].from + 1);
  }
  const std::vector<int> first = FirstSeams(stage, nodes);
  for (std::size_t u = 0; u < split_before.origin.size(); ++u) {
    const int origin = split_before.origin[u];
    for (int i = first[origin]; i < first[origin + 1]; ++i) {
      // The number of earned sets can double with every stage: stop early.
      if (split->own.size() >= max_seams) return false;
      Seam seam = stage.seams[i];
      const int offer = offers.of_seam[i];
      const auto target = unroller->Reach(split_before.state[u], seam, offer);
      seam.from = static_cast<int>(u);
      seam.to = target.node;
      split->own.push_back(seam);
      split->origin.push_back(stage.Origin(i));
      split->place.push_back(stage.Place(i));
      // The gain included every token met; now only those not earned before.
      split->seam_gain.push_back(stage.Gain(i) - Sum(offers.offers[offer]) +
                                 target.gain);
    }
  }
  return true;
}

}  // namespace

std::vector<int> RepeatedTokens(const SearchTrellis& search) {
  struct Sum {
    double total = 0.0;
    double best = 0.0;
    double excess() const { return total - best; }
  };
  std::map<int, Sum> sums;
  for (const SearchStage& stage : search.stages) {
    // Within one stage a path earns a token once, so its best offer counts.
    std::map<int, double> best;
    for (const Node& node : stage.stage->nodes) {
      for (const TokenReward& token : node.tokens) {
        best[token.token] = std::max(best[token.token], token.reward);
      }
    }
    for (const auto& [token, reward] : best) {
      sums[token].total += reward;
      sums[token].best = std::max(sums[token].best, reward);
    }
  }
  std::vector<int> tokens;
  for (const auto& [token, sum] : sums) {
    if (sum.excess() > 0.0) tokens.push_back(token);
  }
  // Excess: how much the Viterbi bound can count too much for the token.
  std::stable_sort(tokens.begin(), tokens.end(), [&](int a, int b) {
    return sums[a].excess() > sums[b].excess();
  });
  return tokens;
}

std::optional<SearchTrellis> UnrollTokens(const SearchTrellis& search,
                                          const std::vector<int>& tokens,
                                          const ScoreGrid& grid,
                                          std::size_t max_seams) {
  const std::vector<StageOffers> offers = FindOffers(search, tokens, grid);
  SearchTrellis unrolled;
  // Start state: nothing earned.
  SplitNodes split_before{{0}, {0}, {Earned(tokens.size(), 0.0)}};
  std::size_t left = max_seams;
  for (std::size_t s = 0; s < search.stages.size(); ++s) {
    const SearchStage& stage = search.stages[s];
    StageUnroller unroller(offers[s], split_before.states);
    SearchStage& split = unrolled.stages.emplace_back();
    if (!UnrollStage(stage, offers[s], split_before, left, &unroller, &split)) {
      return std::nullopt;
    }
    // The limit holds for all stages together.
    left -= split.own.size();
    split.stage = stage.stage;
    split.UseOwn();
    split_before = ToSplitNodes(unroller.keys());
    split.nodes = static_cast<int>(split_before.origin.size());
    split.origin_node = split_before.origin;
  }
  return unrolled;
}

}  // namespace kg_planner
