#include "kg_selector/team/column_team.h"

#include <algorithm>
#include <sstream>
#include <utility>

#include "kg_base/common/input_error.h"
#include "kg_mission/mission/option_names.h"
#include "kg_selector/team/screening.h"

namespace kg_selector {
namespace {

std::vector<std::string> SortedUnique(const std::vector<std::string>& agents) {
  const std::set<std::string> names(agents.begin(), agents.end());
  return {names.begin(), names.end()};
}

// Symmetric key of two columns.
std::size_t PairKey(int a, int b) {
  return (static_cast<std::size_t>(std::max(a, b)) << 32) +
         static_cast<std::size_t>(std::min(a, b));
}

Fairness ParseFairness(const TeamRules& rules) {
  if (rules.fairness == kg_mission::kScarcityFairness) return Fairness::kNone;
  if (rules.fairness == kg_mission::kBalanceFairness) return Fairness::kBalance;
  if (rules.fairness == kg_mission::kMaxMinFairness) return Fairness::kMaxMin;
  throw kg_base::InputError("fairness '" + rules.fairness +
                            "': expected 'scarcity', 'balance' or 'max_min'");
}

}  // namespace

ColumnTeam::ColumnTeam(TeamRules rules, const std::vector<std::string>& agents,
                       std::unique_ptr<TeamSearch> search)
    : rules_(std::move(rules)),
      names_(SortedUnique(agents)),
      rows_(rules_),
      pool_(static_cast<int>(names_.size())),
      search_(std::move(search)),
      waiting_(names_.begin(), names_.end()) {
  pool_.fairness = ParseFairness(rules_);
  pool_.fairness_weight = rules_.fairness_weight;
  pool_.conflict = [this](int a, int b) { return TooClose(a, b); };
  if (!rules_.separation_is_hard && rules_.separation_weight_per_m > 0.0) {
    pool_.penalty = [this](int a, int b) {
      return SoftPenalty(rules_, {pathlets_[a]}, pathlets_[b]);
    };
  }
}

int ColumnTeam::FindIndex(const std::string& agent) const {
  const auto name = std::lower_bound(names_.begin(), names_.end(), agent);
  const bool known = name != names_.end() && *name == agent;
  return known ? static_cast<int>(name - names_.begin()) : kNobody;
}

void ColumnTeam::Offer(const std::string& agent, AgentOffer candidates) {
  if (finished_ || outcome_.unassigned.count(agent) > 0) return;
  if (waiting_.count(agent) == 0 && offers_.count(agent) == 0) return;
  offers_[agent] = std::move(candidates);
  waiting_.erase(agent);
}

void ColumnTeam::Drop(const std::string& agent, const std::string& why) {
  const int index = FindIndex(agent);
  if (finished_ || index == kNobody || outcome_.unassigned.count(agent) > 0) {
    return;
  }
  waiting_.erase(agent);
  offers_.erase(agent);
  favourites_.erase(index);
  pool_.Drop(index);
  search_->Drop(index);
  outcome_.unassigned[agent] = why;
}

bool ColumnTeam::Advance() {
  if (finished_) return true;
  if (!waiting_.empty()) return false;
  const ColumnAnswers answers = CollectOffers();
  FindRows();
  requests_ = search_->Next(pool_, answers);
  for (const auto& [agent, request] : requests_) waiting_.insert(names_[agent]);
  if (waiting_.empty()) {
    Finish();
    return true;
  }
  outcome_.rounds = ++round_ + 1;
  return false;
}

ColumnAnswers ColumnTeam::CollectOffers() {
  ColumnAnswers answers;
  for (auto& [name, candidates] : offers_) {
    const int agent = FindIndex(name);
    // Proven that there is no path: the agent adds 0 to any plan.
    const bool has_none = candidates.pathlets.empty() && candidates.proven;
    ScreenedOffer screened =
        ScreenOffer(rules_, name, std::move(candidates.pathlets), round_);
    refused_[agent] = screened.sound.empty() && !screened.rejected.empty();
    outcome_.rejections.insert(outcome_.rejections.end(),
                               screened.rejected.begin(),
                               screened.rejected.end());
    ColumnAnswer& answer = answers[agent];
    answer.bound = has_none ? 0.0 : candidates.bound;
    for (Pathlet& pathlet : screened.sound) {
      answer.columns.push_back(FindOrAddColumn(agent, std::move(pathlet)));
    }
    if (round_ == 0 && !answer.columns.empty()) {
      favourites_[agent] = answer.columns.front();
    }
  }
  offers_.clear();
  return answers;
}

int ColumnTeam::FindOrAddColumn(int agent, Pathlet pathlet) {
  for (const int column : pool_.columns_of(agent)) {
    if (IsSamePath(pathlets_[column], pathlet)) return column;
  }
  rows_.Add(pathlet);
  Column column;
  column.agent = agent;
  column.score = pathlet.score();
  column.load = FairnessLoad(pathlet);
  pathlets_.push_back(std::move(pathlet));
  return pool_.Add(std::move(column));
}

void ColumnTeam::FindRows() {
  const std::vector<int>& capacities = rows_.capacities();
  while (pool_.capacities().size() < capacities.size()) {
    pool_.AddRow(capacities[pool_.capacities().size()]);
  }
  for (std::size_t c = 0; c < pathlets_.size(); ++c) {
    pool_.SetRows(static_cast<int>(c), rows_.UsedRows(pathlets_[c]));
  }
}

bool ColumnTeam::TooClose(int a, int b) {
  const auto [known, is_new] = too_close_.emplace(PairKey(a, b), false);
  if (!is_new) return known->second;
  const Pathlet& x = pathlets_[std::min(a, b)];
  const Pathlet& y = pathlets_[std::max(a, b)];
  if (x.visits.empty() || y.visits.empty()) return false;
  const double from_s =
      SeparationBegins_s(rules_, x.visits.front().window, x.track, y.track);
  known->second = ComeCloserThan(x.track, y.track, HardSeparation_m(rules_),
                                 {from_s, TimeSpan().to_s});
  return known->second;
}

// Energy as a share of the agent's budget; 0 without a budget.
double ColumnTeam::FairnessLoad(const Pathlet& pathlet) const {
  const auto budget_j = rules_.energy_budget_j.find(pathlet.agent);
  if (budget_j == rules_.energy_budget_j.end() || !(budget_j->second > 0.0)) {
    return 0.0;
  }
  return std::max(0.0, pathlet.energy_j / budget_j->second);
}

PlanRequest ColumnTeam::RequestFor(const std::string& agent) const {
  const auto asked = requests_.find(FindIndex(agent));
  if (asked == requests_.end()) return RequestAround(rules_, {});
  std::vector<Pathlet> around;
  for (const int column : asked->second.around) {
    around.push_back(pathlets_[column]);
  }
  PlanRequest request = RequestAround(rules_, around);
  rows_.PutPrices(agent, asked->second.prices, &request);
  return request;
}

void ColumnTeam::Finish() {
  finished_ = true;
  outcome_.bound = search_->bound();
  for (const int column : search_->choice()) {
    if (column != kNobody) outcome_.committed.push_back(pathlets_[column]);
  }
  std::sort(outcome_.committed.begin(), outcome_.committed.end(),
            [](const Pathlet& a, const Pathlet& b) {
              return a.score() != b.score() ? a.score() > b.score()
                                            : a.agent < b.agent;
            });
  // Reasons of the other agents without a path, as far as known.
  for (std::size_t a = 0; a < names_.size(); ++a) {
    const bool served =
        a < search_->choice().size() && search_->choice()[a] != kNobody;
    if (served || outcome_.unassigned.count(names_[a]) > 0) continue;
    outcome_.unassigned[names_[a]] =
        !pool_.columns_of(static_cast<int>(a)).empty()
            ? "found no path beside the others'"
        : refused_[static_cast<int>(a)] ? "offered nothing that keeps the rules"
                                        : "found no path";
  }
  RejectFavourites();
}

void ColumnTeam::RejectFavourites() {
  for (const auto& [agent, column] : favourites_) {
    const int chosen = search_->choice()[agent];
    if (chosen == column) continue;
    std::vector<Pathlet> others;
    for (const Pathlet& pathlet : outcome_.committed) {
      if (pathlet.agent != names_[agent]) others.push_back(pathlet);
    }
    const Pathlet& favourite = pathlets_[column];
    const double kept = chosen == kNobody ? 0.0 : pathlets_[chosen].score();
    // No hard conflict with the plan: it was outbid.
    Conflict conflict{ConflictKind::kOutbid, "", -1, "",
                      favourite.score() - kept};
    if (const auto hard = FindConflict(rules_, others, favourite)) {
      conflict = *hard;
    }
    std::ostringstream reason;
    reason << conflict.Line();
    const double price =
        favourite.score() - pool_.Reduced(column, search_->prices());
    if (price > 0.0) reason << "; its places and events cost " << price;
    outcome_.rejections.push_back({favourite, conflict, reason.str(), 0});
  }
}

}  // namespace kg_selector
