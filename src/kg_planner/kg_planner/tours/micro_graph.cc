#include "kg_planner/tours/micro_graph.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <tuple>

namespace kg_planner {
namespace {

bool IsNonNegative(double value) { return std::isfinite(value) && value >= 0; }

[[noreturn]] void Refuse(const std::string& what, std::size_t index,
                         const std::string& why) {
  throw std::invalid_argument(what + " " + std::to_string(index) + ": " + why);
}

void CheckNode(const Node& node, std::size_t index) {
  if (!std::isfinite(node.reward)) Refuse("node", index, "reward not finite");
  for (const TokenReward& token : node.tokens) {
    if (!IsNonNegative(token.reward)) {
      Refuse("node", index, "token reward not finite and >= 0");
    }
  }
}

void CheckLeg(const Leg& leg, std::size_t index, int nodes) {
  if (!(leg.from >= -1 && leg.from < nodes && leg.to >= 0 && leg.to < nodes)) {
    Refuse("leg", index, "no such node");
  }
  if (leg.from == leg.to) Refuse("leg", index, "leads to where it begins");
  if (!IsNonNegative(leg.cost)) Refuse("leg", index, "cost not finite, >= 0");
  if (!IsNonNegative(leg.resource)) {
    Refuse("leg", index, "resource not finite and >= 0");
  }
  if (!IsNonNegative(leg.duration)) {
    Refuse("leg", index, "duration not finite and >= 0");
  }
}

bool ByPair(const Leg& a, const Leg& b) {
  return std::tie(a.from, a.to) < std::tie(b.from, b.to);
}

}  // namespace

MicroGraph::MicroGraph(const StageProblem& problem)
    : nodes_(problem.nodes),
      legs_(problem.legs),
      first_(problem.nodes.size() + 2, 0),
      duration_limit_(problem.duration_limit) {
  if (!(duration_limit_ >= 0.0)) {
    throw std::invalid_argument("duration limit: not a number >= 0");
  }
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    CheckNode(nodes_[i], i);
    has_tokens_ = has_tokens_ || !nodes_[i].tokens.empty();
  }
  for (std::size_t i = 0; i < legs_.size(); ++i) CheckLeg(legs_[i], i, size());
  std::sort(legs_.begin(), legs_.end(), ByPair);
  for (std::size_t i = 1; i < legs_.size(); ++i) {
    if (!ByPair(legs_[i - 1], legs_[i])) {
      throw std::invalid_argument("legs: " + std::to_string(legs_[i].from) +
                                  " to " + std::to_string(legs_[i].to) +
                                  " occurs twice");
    }
  }
  for (const Leg& leg : legs_) ++first_[leg.from + 2];
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
}

const Leg* MicroGraph::Find(int from, int to) const {
  Leg wanted;
  wanted.from = from;
  wanted.to = to;
  const Leg* found = std::lower_bound(begin(from), end(from), wanted, ByPair);
  return found != end(from) && found->to == to ? found : nullptr;
}

double MicroGraph::TotalReward(const std::vector<int>& set) const {
  double reward = 0.0;
  for (int node : set) reward += nodes_[node].reward;
  if (!has_tokens_) return reward;
  // Largest reward of each token in the set: sorted by token, then by
  // descending reward, it is the first.
  std::vector<TokenReward> tokens;
  for (int node : set) {
    tokens.insert(tokens.end(), nodes_[node].tokens.begin(),
                  nodes_[node].tokens.end());
  }
  std::sort(tokens.begin(), tokens.end(),
            [](const TokenReward& a, const TokenReward& b) {
              return std::tie(a.token, b.reward) < std::tie(b.token, a.reward);
            });
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (i == 0 || tokens[i].token != tokens[i - 1].token) {
      reward += tokens[i].reward;
    }
  }
  return reward;
}

MicroPath MicroGraph::Walk(const std::vector<int>& nodes) const {
  MicroPath path;
  int at = -1;
  for (int node : nodes) {
    const Leg* leg = Find(at, node);
    if (leg == nullptr) return {};
    path.cost += leg->cost;
    path.resource += leg->resource;
    path.duration += leg->duration;
    at = node;
  }
  if (!(path.duration <= duration_limit_)) return {};
  std::vector<int> set = nodes;
  std::sort(set.begin(), set.end());
  path.reward = TotalReward(set);
  path.nodes = nodes;
  return path;
}

bool BetterOrder(const MicroPath& a, const MicroPath& b) {
  return std::tie(a.cost, a.duration, a.resource, a.nodes) <
         std::tie(b.cost, b.duration, b.resource, b.nodes);
}

}  // namespace kg_planner
