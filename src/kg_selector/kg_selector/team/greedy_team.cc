#include "kg_selector/team/greedy_team.h"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

#include "kg_selector/team/screening.h"

namespace kg_selector {
namespace {

constexpr double kNoValue = -std::numeric_limits<double>::infinity();

// An agent without a path adds 0.
double OfferBound(const AgentOffer& candidates) {
  if (candidates.pathlets.empty() && candidates.proven) return 0.0;
  return candidates.bound < 0.0 ? 0.0 : candidates.bound;
}

}  // namespace

GreedyTeam::GreedyTeam(TeamRules rules, std::vector<std::string> agents)
    : rules_(std::move(rules)), waiting_(agents.begin(), agents.end()) {}

void GreedyTeam::Offer(const std::string& agent, AgentOffer candidates) {
  if (waiting_.count(agent) == 0 && offers_.count(agent) == 0) return;
  if (round_ == 0) bounds_[agent] = OfferBound(candidates);
  ScreenedOffer screened =
      ScreenOffer(rules_, agent, std::move(candidates.pathlets), round_);
  offers_[agent] = std::move(screened.sound);
  rejected_[agent] = std::move(screened.rejected);
  waiting_.erase(agent);
}

void GreedyTeam::Drop(const std::string& agent, const std::string& why) {
  if (waiting_.count(agent) == 0 && offers_.count(agent) == 0) return;
  offers_.erase(agent);
  bounds_.erase(agent);
  rejected_.erase(agent);
  waiting_.erase(agent);
  outcome_.unassigned[agent] = why;
}

bool GreedyTeam::Advance() {
  if (!waiting_.empty()) return false;
  RecordRejected();
  DropAgentsWithoutPath();
  RequestAgain();
  for (std::string agent = Next(); !agent.empty(); agent = Next()) {
    Commit(agent, FindFavourite(offers_.at(agent)).index);
    RequestAgain();
  }
  if (!waiting_.empty() && round_ + 1 < rules_.max_rounds) {
    outcome_.rounds = ++round_ + 1;
    return false;
  }
  if (!waiting_.empty()) CommitFromOffers();
  outcome_.bound = 0.0;  // Sum of each agent's bound alone.
  for (const auto& [agent, bound] : bounds_) outcome_.bound += bound;
  return true;
}

PlanRequest GreedyTeam::RequestFor(const std::string& /*agent*/) const {
  return RequestAround(rules_, outcome_.committed);
}

double GreedyTeam::Value(const Pathlet& pathlet) const {
  return pathlet.score() - SoftPenalty(rules_, outcome_.committed, pathlet);
}

GreedyTeam::Favourite GreedyTeam::FindFavourite(
    const std::vector<Pathlet>& offer) const {
  Favourite favourite{0, kNoValue};
  for (std::size_t i = 0; i < offer.size(); ++i) {
    const double value = Value(offer[i]);
    if (value > favourite.value) favourite = {i, value};
  }
  return favourite;
}

double GreedyTeam::SecondChoice(const std::vector<Pathlet>& offer,
                                std::size_t favourite) const {
  double second = kNoValue;
  for (std::size_t i = 0; i < offer.size(); ++i) {
    const double value = Value(offer[i]);
    if (i != favourite && value > second &&
        !FindConflict(rules_, outcome_.committed, offer[i])) {
      second = value;
    }
  }
  return second;
}

void GreedyTeam::RecordRejected() {
  for (auto& [agent, rejected] : rejected_) {
    outcome_.rejections.insert(outcome_.rejections.end(), rejected.begin(),
                               rejected.end());
    if (!rejected.empty() && offers_.count(agent) > 0 &&
        offers_.at(agent).empty()) {
      outcome_.unassigned[agent] = "offered nothing that keeps the rules";
      offers_.erase(agent);
    }
  }
  rejected_.clear();
}

void GreedyTeam::DropAgentsWithoutPath() {
  for (auto offer = offers_.begin(); offer != offers_.end();) {
    if (!offer->second.empty()) {
      ++offer;
      continue;
    }
    outcome_.unassigned[offer->first] =
        outcome_.committed.empty() ? "found no path"
                                   : "found no path around those committed";
    offer = offers_.erase(offer);
  }
}

// An agent whose favourite conflicts with a committed path must plan again.
void GreedyTeam::RequestAgain() {
  for (const auto& [agent, offer] : offers_) {
    if (waiting_.count(agent) > 0) continue;
    const Pathlet& favourite = offer[FindFavourite(offer).index];
    const auto conflict = FindConflict(rules_, outcome_.committed, favourite);
    if (!conflict) continue;
    outcome_.rejections.push_back(
        {favourite, *conflict, conflict->Line(), round_});
    waiting_.insert(agent);
  }
}

bool GreedyTeam::OutranksWaiting(double value) const {
  return std::all_of(
      waiting_.begin(), waiting_.end(), [&](const std::string& agent) {
        const std::vector<Pathlet>& offer = offers_.at(agent);
        return std::all_of(
            offer.begin(), offer.end(),
            [&](const Pathlet& pathlet) { return pathlet.score() < value; });
      });
}

std::string GreedyTeam::Next() const {
  std::map<std::string, Favourite> ready;
  double best = kNoValue;
  for (const auto& [agent, offer] : offers_) {
    if (waiting_.count(agent) > 0) continue;
    ready[agent] = FindFavourite(offer);
    best = std::max(best, ready[agent].value);
  }
  if (ready.empty() || !OutranksWaiting(best)) return "";
  std::vector<std::pair<double, std::string>> tied;  // (second choice, IRI)
  for (const auto& [agent, favourite] : ready) {
    if (favourite.value == best) tied.emplace_back(0.0, agent);
  }
  if (tied.size() == 1) return tied.front().second;
  for (auto& [second, agent] : tied) {
    second = SecondChoice(offers_.at(agent), ready[agent].index);
  }
  return std::min_element(tied.begin(), tied.end())->second;
}

void GreedyTeam::Commit(const std::string& agent, std::size_t index) {
  outcome_.committed.push_back(std::move(offers_.at(agent)[index]));
  offers_.erase(agent);
  waiting_.erase(agent);
}

// Out of rounds: commits the best remaining conflict-free offer until there is
// none.
void GreedyTeam::CommitFromOffers() {
  while (true) {
    // (value, agent, index of the path in its offer)
    std::tuple<double, std::string, std::size_t> best(kNoValue, "", 0);
    for (const auto& [agent, offer] : offers_) {
      for (std::size_t i = 0; i < offer.size(); ++i) {
        const double value = Value(offer[i]);
        if (value > std::get<0>(best) &&
            !FindConflict(rules_, outcome_.committed, offer[i])) {
          best = {value, agent, i};
        }
      }
    }
    if (std::get<1>(best).empty()) break;
    Commit(std::get<1>(best), std::get<2>(best));
  }
  for (const auto& [agent, offer] : offers_) {
    outcome_.unassigned[agent] = "offered nothing without a conflict in " +
                                 std::to_string(outcome_.rounds) + " rounds";
  }
  offers_.clear();
  waiting_.clear();
}

}  // namespace kg_selector
