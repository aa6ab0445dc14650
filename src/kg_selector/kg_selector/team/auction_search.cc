#include "kg_selector/team/auction_search.h"

#include <algorithm>
#include <iterator>

namespace kg_selector {
namespace {

// Maximum share of rounds spent on bids.
constexpr double kBidShare = 0.6;
// Group waves without gain before the search stops.
constexpr int kMaxFailedWaves = 10;

}  // namespace

void AuctionSearch::Drop(int agent) {
  dropped_.insert(agent);
  relaxation_.Drop(agent);
  groups_.Drop(agent);
  for (TeamChoice* choice : {&held_, &best_}) {
    if (!choice->empty()) (*choice)[agent] = kNobody;
  }
}

ColumnRequests AuctionSearch::Next(const TeamColumns& pool,
                                   const ColumnAnswers& answers) {
  prices_.resize(pool.capacities().size(), 0.0);
  // Round 0 was asked without prices: its bounds are those of prices 0.
  if (rounds_++ == 0) {
    held_.assign(pool.agents(), kNobody);
    best_ = held_;
    relaxation_.Learn(pool.capacities(), SummarizeAnswers(pool, answers));
  }
  switch (phase_) {
    case Phase::kBids:
      return AfterBids(pool, answers);
    case Phase::kFinal:
      relaxation_.Learn(pool.capacities(), SummarizeAnswers(pool, answers));
      return AfterAuction(pool);
    case Phase::kGroups:
      return AfterGroups(pool, answers);
    case Phase::kUnserved:
      KeepIfBetter(pool, best_);
      return RequestUnserved();
  }
  return {};
}

ColumnRequests AuctionSearch::AfterBids(const TeamColumns& pool,
                                        const ColumnAnswers& answers) {
  ProcessBids(pool, answers);
  ColumnRequests requests = RequestBids(pool);
  if (!requests.empty() && rounds_ + 2 < kBidShare * options_.max_rounds) {
    return requests;
  }
  if (rounds_ >= options_.max_rounds) return AfterAuction(pool);
  phase_ = Phase::kFinal;
  relaxation_.Set(prices_);
  return RequestAll(prices_, pool.agents(), dropped_);
}

ColumnRequests AuctionSearch::AfterAuction(const TeamColumns& pool) {
  KeepIfBetter(pool, held_);
  KeepIfBetter(pool, ChooseGreedily(pool, {}));
  return RequestGroups(pool);
}

ColumnRequests AuctionSearch::AfterGroups(const TeamColumns& pool,
                                          const ColumnAnswers& answers) {
  ColumnRequests requests = groups_.Next(answers);
  if (!requests.empty() && rounds_ + 1 < options_.max_rounds) return requests;
  const TeamChoice choice = groups_.End(pool, pool.Worth(best_), 0.0);
  const bool better = IsMore(pool.Worth(choice), pool.Worth(best_));
  failed_waves_ = better ? 0 : failed_waves_ + 1;
  if (better) best_ = choice;
  return RequestGroups(pool);
}

ColumnRequests AuctionSearch::RequestGroups(const TeamColumns& pool) {
  phase_ = Phase::kGroups;
  if (failed_waves_ <= kMaxFailedWaves && rounds_ + 2 < options_.max_rounds) {
    ColumnRequests requests = groups_.Begin(pool, best_, prices_);
    if (!requests.empty()) return requests;
  }
  phase_ = Phase::kUnserved;
  KeepIfBetter(pool, best_);
  return RequestUnserved();
}

ColumnRequests AuctionSearch::RequestUnserved() {
  if (rounds_ >= options_.max_rounds || !asked_unserved_.insert(best_).second) {
    return {};
  }
  return RequestUnservedBeside(best_, dropped_);
}

void AuctionSearch::KeepIfBetter(const TeamColumns& pool,
                                 const TeamChoice& choice) {
  TeamChoice better = Exchange(pool, prices_, choice, {});
  if (IsMore(pool.Worth(better), pool.Worth(best_))) best_ = std::move(better);
}

// Bids in order of decreasing gain.
void AuctionSearch::ProcessBids(const TeamColumns& pool,
                                const ColumnAnswers& answers) {
  std::vector<std::pair<double, int>> order;
  for (const auto& [agent, answer] : answers) {
    if (dropped_.count(agent) > 0) continue;
    if (answer.columns.empty()) {
      retired_.insert(agent);
    } else {
      order.emplace_back(-pool.Reduced(answer.columns.front(), prices_), agent);
    }
  }
  std::sort(order.begin(), order.end());
  std::set<int> raised;
  for (const auto& [value, agent] : order) {
    ProcessBid(pool, agent, answers.at(agent), &raised);
  }
}

std::vector<int> AuctionSearch::FullRows(const TeamColumns& pool,
                                         int column) const {
  std::vector<int> full;
  for (const int row : pool.columns()[column].rows) {
    int users = 0;
    for (const int other : ChosenColumns(held_)) {
      const std::vector<int>& rows = pool.columns()[other].rows;
      users += std::binary_search(rows.begin(), rows.end(), row);
    }
    if (users >= pool.capacities()[row]) full.push_back(row);
  }
  return full;
}

// Whether the column conflicts with an agent with which it shares no full row:
// then the bidder has to plan around that agent.
bool AuctionSearch::IsBlocked(const TeamColumns& pool, int column) {
  const int agent = pool.columns()[column].agent;
  bool blocked = false;
  for (const int other : ChosenColumns(held_)) {
    const Column& its = pool.columns()[other];
    std::vector<int> common;
    std::set_intersection(
        its.rows.begin(), its.rows.end(), pool.columns()[column].rows.begin(),
        pool.columns()[column].rows.end(), std::back_inserter(common));
    const bool displaced =
        std::any_of(common.begin(), common.end(),
                    [&](int r) { return pool.capacities()[r] <= 1; });
    if (displaced || !pool.Conflict(other, column)) continue;
    blocked_.insert({agent, its.agent});
    blocked = true;
  }
  return blocked;
}

// Price increment: advantage over the second choice, plus epsilon.
double AuctionSearch::Raise(const TeamColumns& pool,
                            const ColumnAnswer& answer) const {
  const int column = answer.columns.front();
  const double best = pool.Reduced(column, prices_);
  double second = pool.unserved();
  for (const int other : pool.columns_of(pool.columns()[column].agent)) {
    if (other != column) {
      second = std::max(second, pool.Reduced(other, prices_));
    }
  }
  return std::max(0.0, best - second) + options_.epsilon;
}

void AuctionSearch::ProcessBid(const TeamColumns& pool, int agent,
                               const ColumnAnswer& answer,
                               std::set<int>* raised) {
  const int column = answer.columns.front();
  if (!(pool.Reduced(column, prices_) > pool.unserved() - options_.epsilon)) {
    retired_.insert(agent);
    return;
  }
  const std::vector<int> full = FullRows(pool, column);
  const bool already_raised =
      std::any_of(full.begin(), full.end(), [&](int row) {
        return raised->count(row) > 0 || pool.capacities()[row] == 0;
      });
  const bool blocked = IsBlocked(pool, column);
  if (already_raised || blocked) {
    for (const int row : full) {
      if (pool.capacities()[row] == 0) retired_.insert(agent);
    }
    return;  // Will bid again at the new prices.
  }
  const double raise = Raise(pool, answer);
  for (const int row : full) {
    prices_[row] +=
        std::max(options_.epsilon, raise / static_cast<double>(full.size()));
    int min_value = kNobody;  // Holder of the row with the lowest score.
    for (const int other : ChosenColumns(held_)) {
      const std::vector<int>& rows = pool.columns()[other].rows;
      if (std::binary_search(rows.begin(), rows.end(), row) &&
          (min_value == kNobody ||
           pool.columns()[other].score < pool.columns()[min_value].score)) {
        min_value = other;
      }
    }
    if (min_value != kNobody) held_[pool.columns()[min_value].agent] = kNobody;
  }
  raised->insert(pool.columns()[column].rows.begin(),
                 pool.columns()[column].rows.end());
  held_[agent] = column;
}

ColumnRequests AuctionSearch::RequestBids(const TeamColumns& pool) const {
  ColumnRequests requests;
  for (int agent = 0; agent < pool.agents(); ++agent) {
    if (held_[agent] != kNobody || retired_.count(agent) > 0 ||
        dropped_.count(agent) > 0) {
      continue;
    }
    requests[agent].prices = prices_;
    for (const int column : ChosenColumns(held_)) {
      if (blocked_.count({agent, pool.columns()[column].agent}) > 0) {
        requests[agent].around.push_back(column);
      }
    }
  }
  return requests;
}

}  // namespace kg_selector
