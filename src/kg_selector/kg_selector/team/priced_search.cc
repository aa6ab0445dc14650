#include "kg_selector/team/priced_search.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace kg_selector {
namespace {

// Maximum share of rounds spent on prices.
constexpr double kPriceShare = 0.5;
// Columns per agent that Exchange() tries: in every round, and at the end of a
// phase.
constexpr int kKeptColumns = 15;
constexpr int kManyColumns = 100;
// Initial slack of group exchanges: a share of the best score, divided by the
// square of the number of agents; large teams have more improving moves.
constexpr double kExchangeSlack = 0.3;

}  // namespace

void PricedSearch::Drop(int agent) {
  dropped_.insert(agent);
  displaced_.erase(agent);
  prices_.Drop(agent);
  groups_.Drop(agent);
  for (TeamChoice* choice : {&best_, &current_, &partial_}) {
    if (!choice->empty()) (*choice)[agent] = kNobody;
  }
}

ColumnRequests PricedSearch::Next(const TeamColumns& pool,
                                  const ColumnAnswers& answers) {
  if (best_.empty()) best_.assign(pool.agents(), kNobody);
  ++rounds_;
  switch (phase_) {
    case Phase::kPrices:
      return AfterPrices(pool, answers);
    case Phase::kRepair:
      return AfterRepair(pool, answers);
    case Phase::kGroups:
      return AfterGroups(pool, answers);
    case Phase::kUnserved:
      KeepIfBetter(pool, best_, kManyColumns);
      return RequestUnserved();
  }
  return {};
}

ColumnRequests PricedSearch::AfterPrices(const TeamColumns& pool,
                                         const ColumnAnswers& answers) {
  prices_.Learn(pool.capacities(), SummarizeAnswers(pool, answers));
  partial_.assign(pool.agents(), kNobody);
  FitColumns(pool, answers);
  KeepIfBetter(pool, partial_, kKeptColumns);
  if (IsCloseEnough(pool)) return RequestUnserved();
  if (rounds_ < kPriceShare * options_.max_rounds && !prices_.settled()) {
    return RequestAtPrices(pool);
  }
  return AfterRepair(pool, {});
}

ColumnRequests PricedSearch::AfterRepair(const TeamColumns& pool,
                                         const ColumnAnswers& answers) {
  FitColumns(pool, answers);
  if (!displaced_.empty() && rounds_ + 1 < options_.max_rounds) {
    phase_ = Phase::kRepair;
    ColumnRequests requests;
    for (const int agent : displaced_) {
      requests[agent] = {prices_.prices(), ChosenColumns(partial_)};
    }
    return requests;
  }
  KeepIfBetter(pool, partial_, kManyColumns);
  current_ = best_;
  return RequestGroups(pool);
}

ColumnRequests PricedSearch::AfterGroups(const TeamColumns& pool,
                                         const ColumnAnswers& answers) {
  ColumnRequests requests = groups_.Next(answers);
  if (!requests.empty() && rounds_ + 1 < options_.max_rounds) return requests;
  const double left = 1.0 - 1.0 * rounds_ / options_.max_rounds;
  const double slack = kExchangeSlack * left * std::abs(pool.Score(best_)) /
                       (static_cast<double>(pool.agents()) * pool.agents());
  current_ = groups_.End(pool, pool.Worth(best_), slack);
  if (IsMore(pool.Worth(current_), pool.Worth(best_))) best_ = current_;
  return RequestGroups(pool);
}

// Keeps columns in order of decreasing reduced value; agents that no longer fit
// are displaced.
void PricedSearch::FitColumns(const TeamColumns& pool,
                              const ColumnAnswers& answers) {
  std::vector<std::pair<double, int>> order;
  for (const auto& [agent, answer] : answers) {
    if (!answer.columns.empty()) {
      order.emplace_back(
          -pool.Reduced(answer.columns.front(), prices_.prices()),
          answer.columns.front());
    }
  }
  std::sort(order.begin(), order.end());
  // Highest reduced value first: it would lose most.
  if (!answers.empty()) displaced_.clear();
  for (const auto& [value, column] : order) {
    const int agent = pool.columns()[column].agent;
    TeamChoice with = partial_;
    with[agent] = column;
    if (pool.IsAllowed(with)) {
      partial_ = std::move(with);
    } else {
      displaced_.insert(agent);
    }
  }
}

void PricedSearch::KeepIfBetter(const TeamColumns& pool, TeamChoice choice,
                                int columns) {
  choice = Exchange(pool, prices_.best_prices(), std::move(choice),
                    {columns, columns / 5});
  if (IsMore(pool.Worth(choice), pool.Worth(best_))) best_ = std::move(choice);
}

bool PricedSearch::IsCloseEnough(const TeamColumns& pool) const {
  const double plan = pool.Score(best_);
  return bound() - plan <= options_.gap_goal * std::abs(bound());
}

ColumnRequests PricedSearch::RequestAtPrices(const TeamColumns& pool) {
  phase_ = Phase::kPrices;
  prices_.Step(pool.Score(best_));
  return RequestAll(prices_.prices(), pool.agents(), dropped_);
}

ColumnRequests PricedSearch::RequestGroups(const TeamColumns& pool) {
  if (rounds_ + 2 >= options_.max_rounds || IsCloseEnough(pool)) {
    KeepIfBetter(pool, best_, kManyColumns);
    return RequestUnserved();
  }
  phase_ = Phase::kGroups;
  ColumnRequests requests =
      groups_.Begin(pool, current_, prices_.best_prices());
  return requests.empty() ? RequestUnserved() : requests;
}

ColumnRequests PricedSearch::RequestUnserved() {
  phase_ = Phase::kUnserved;
  if (rounds_ >= options_.max_rounds || !asked_unserved_.insert(best_).second) {
    return {};
  }
  return RequestUnservedBeside(best_, dropped_);
}

}  // namespace kg_selector
