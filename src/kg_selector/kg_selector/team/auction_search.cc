#include "kg_selector/team/auction_search.h"

#include <algorithm>
#include <iterator>

namespace kg_selector {
namespace {

// Of the rounds, how many may go into bids.
constexpr double kBidShare = 0.6;
// Waves of groups that find nothing better, before they are given up.
constexpr int kWavesInVain = 10;

}  // namespace

void AuctionSearch::Drop(int agent) {
  dropped_.insert(agent);
  relaxation_.Drop(agent);
  groups_.Drop(agent);
  for (TeamChoice* choice : {&held_, &best_})
    if (!choice->empty()) (*choice)[agent] = kNobody;
}

ColumnAsks AuctionSearch::Next(const TeamColumns& pool,
                               const ColumnAnswers& answers) {
  prices_.resize(pool.capacities().size(), 0.0);
  if (rounds_++ == 0) {
    held_.assign(pool.agents(), kNobody);
    best_ = held_;
    relaxation_.Learn(pool.capacities(), AnswersOf(pool, answers));
  }
  switch (phase_) {
    case Phase::kBids:
      return AfterBids(pool, answers);
    case Phase::kFinal:
      relaxation_.Learn(pool.capacities(), AnswersOf(pool, answers));
      return AfterAuction(pool);
    case Phase::kGroups:
      return AfterGroups(pool, answers);
    case Phase::kUnserved:
      Keep(pool, best_);
      return AskUnserved();
  }
  return {};
}

ColumnAsks AuctionSearch::AfterBids(const TeamColumns& pool,
                                    const ColumnAnswers& answers) {
  TakeBids(pool, answers);
  ColumnAsks asks = AskBidders(pool);
  if (!asks.empty() && rounds_ + 2 < kBidShare * options_.max_rounds)
    return asks;
  if (rounds_ >= options_.max_rounds) return AfterAuction(pool);
  phase_ = Phase::kFinal;
  relaxation_.Set(prices_);
  return AskAllAt(prices_, pool.agents(), dropped_);
}

ColumnAsks AuctionSearch::AfterAuction(const TeamColumns& pool) {
  Keep(pool, held_);
  Keep(pool, ChooseGreedily(pool, {}));
  return AskGroups(pool);
}

ColumnAsks AuctionSearch::AfterGroups(const TeamColumns& pool,
                                      const ColumnAnswers& answers) {
  ColumnAsks asks = groups_.Next(answers);
  if (!asks.empty() && rounds_ + 1 < options_.max_rounds) return asks;
  const TeamChoice choice = groups_.End(pool, pool.Worth(best_), 0.0);
  const bool better = IsMore(pool.Worth(choice), pool.Worth(best_));
  in_vain_ = better ? 0 : in_vain_ + 1;
  if (better) best_ = choice;
  return AskGroups(pool);
}

ColumnAsks AuctionSearch::AskGroups(const TeamColumns& pool) {
  phase_ = Phase::kGroups;
  if (in_vain_ <= kWavesInVain && rounds_ + 2 < options_.max_rounds) {
    ColumnAsks asks = groups_.Begin(pool, best_, prices_);
    if (!asks.empty()) return asks;
  }
  phase_ = Phase::kUnserved;
  Keep(pool, best_);
  return AskUnserved();
}

ColumnAsks AuctionSearch::AskUnserved() {
  if (rounds_ >= options_.max_rounds || !asked_unserved_.insert(best_).second)
    return {};
  return AskUnservedBeside(best_, dropped_);
}

void AuctionSearch::Keep(const TeamColumns& pool, const TeamChoice& choice) {
  TeamChoice better = Exchange(pool, prices_, choice, {});
  if (IsMore(pool.Worth(better), pool.Worth(best_))) best_ = std::move(better);
}

// Who gains most bids first.
void AuctionSearch::TakeBids(const TeamColumns& pool,
                             const ColumnAnswers& answers) {
  std::vector<std::pair<double, int>> order;
  for (const auto& [agent, answer] : answers) {
    if (dropped_.count(agent) > 0) continue;
    if (answer.columns.empty())
      out_.insert(agent);
    else
      order.emplace_back(-pool.Reduced(answer.columns.front(), prices_), agent);
  }
  std::sort(order.begin(), order.end());
  std::set<int> raised;
  for (const auto& [value, agent] : order)
    TakeBid(pool, agent, answers.at(agent), &raised);
}

std::vector<int> AuctionSearch::FullRows(const TeamColumns& pool,
                                         int column) const {
  std::vector<int> full;
  for (const int row : pool.columns()[column].rows) {
    int users = 0;
    for (const int other : ColumnsOf(held_)) {
      const std::vector<int>& rows = pool.columns()[other].rows;
      users += std::binary_search(rows.begin(), rows.end(), row);
    }
    if (users >= pool.capacities()[row]) full.push_back(row);
  }
  return full;
}

// By somebody who shares no full row: then it has to be planned around.
bool AuctionSearch::IsBlocked(const TeamColumns& pool, int column) {
  const int agent = pool.columns()[column].agent;
  bool blocked = false;
  for (const int other : ColumnsOf(held_)) {
    const Column& its = pool.columns()[other];
    std::vector<int> common;
    std::set_intersection(
        its.rows.begin(), its.rows.end(), pool.columns()[column].rows.begin(),
        pool.columns()[column].rows.end(), std::back_inserter(common));
    const bool ousted = std::any_of(common.begin(), common.end(), [&](int r) {
      return pool.capacities()[r] <= 1;
    });
    if (ousted || !pool.Conflict(other, column)) continue;
    blocked_.insert({agent, its.agent});
    blocked = true;
  }
  return blocked;
}

// The advantage over the second choice, and epsilon.
double AuctionSearch::Raise(const TeamColumns& pool,
                            const ColumnAnswer& answer) const {
  const int column = answer.columns.front();
  const double best = pool.Reduced(column, prices_);
  double second = pool.unserved();
  for (const int other : pool.of_agent(pool.columns()[column].agent))
    if (other != column)
      second = std::max(second, pool.Reduced(other, prices_));
  return std::max(0.0, best - second) + options_.epsilon;
}

void AuctionSearch::TakeBid(const TeamColumns& pool, int agent,
                            const ColumnAnswer& answer, std::set<int>* raised) {
  const int column = answer.columns.front();
  if (!(pool.Reduced(column, prices_) > pool.unserved() - options_.epsilon)) {
    out_.insert(agent);
    return;
  }
  const std::vector<int> full = FullRows(pool, column);
  const bool late = std::any_of(full.begin(), full.end(), [&](int row) {
    return raised->count(row) > 0 || pool.capacities()[row] == 0;
  });
  const bool blocked = IsBlocked(pool, column);
  if (late || blocked) {
    for (const int row : full)
      if (pool.capacities()[row] == 0) out_.insert(agent);
    return;  // Bids again, at the new prices.
  }
  const double raise = Raise(pool, answer);
  for (const int row : full) {
    prices_[row] +=
        std::max(options_.epsilon, raise / static_cast<double>(full.size()));
    int least = kNobody;  // Of those who hold it: who bid least for it.
    for (const int other : ColumnsOf(held_)) {
      const std::vector<int>& rows = pool.columns()[other].rows;
      if (std::binary_search(rows.begin(), rows.end(), row) &&
          (least == kNobody ||
           pool.columns()[other].score < pool.columns()[least].score))
        least = other;
    }
    if (least != kNobody) held_[pool.columns()[least].agent] = kNobody;
  }
  raised->insert(pool.columns()[column].rows.begin(),
                 pool.columns()[column].rows.end());
  held_[agent] = column;
}

ColumnAsks AuctionSearch::AskBidders(const TeamColumns& pool) const {
  ColumnAsks asks;
  for (int agent = 0; agent < pool.agents(); ++agent) {
    if (held_[agent] != kNobody || out_.count(agent) > 0 ||
        dropped_.count(agent) > 0)
      continue;
    asks[agent].prices = prices_;
    for (const int column : ColumnsOf(held_))
      if (blocked_.count({agent, pool.columns()[column].agent}) > 0)
        asks[agent].around.push_back(column);
  }
  return asks;
}

}  // namespace kg_selector
