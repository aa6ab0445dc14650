#include "kg_selector/team/team_prices.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace kg_selector {
namespace {

constexpr double kLeastShare =
    0.1;  // Minimum weight of the newest answers in the average.
constexpr int kMaxFailedSteps =
    2;  // Steps without gain before they get shorter.
// Assumed gap of the best plan, as a share of the bound, until a better plan is
// known.
constexpr double kLikelyGap = 0.05;
// Settled: the bound fell by less than this share in kSettledRounds rounds.
constexpr double kSettledShare = 2e-4;
constexpr std::size_t kSettledRounds = 30;

double AtLeastZero(double bound) { return bound < 0.0 ? 0.0 : bound; }

}  // namespace

void TeamPrices::Grow(std::size_t rows) {
  prices_.resize(rows, 0.0);
  best_prices_.resize(rows, 0.0);
  average_usage_.resize(rows, 0.0);
}

double TeamPrices::bound() const {
  return std::accumulate(agents_part_.begin(), agents_part_.end(), rows_part_);
}

void TeamPrices::Drop(int agent) {
  if (agent < static_cast<int>(agents_part_.size())) agents_part_[agent] = 0.0;
}

void TeamPrices::Learn(const std::vector<int>& capacities,
                       const Answers& answers) {
  capacities_ = capacities;
  Grow(capacities.size());
  // L at the requested prices: rows' part and agents' part.
  double rows = 0.0;
  for (std::size_t r = 0; r < capacities.size(); ++r) {
    rows += prices_[r] * capacities[r];
  }
  std::vector<double> agents;
  for (const double bound : answers.bounds) {
    agents.push_back(AtLeastZero(bound));
  }
  const double value = std::accumulate(agents.begin(), agents.end(), rows);
  // Running mean of the first answers, then exponential.
  const double share = std::max(kLeastShare, 1.0 / (1.0 + bounds_.size()));
  for (std::size_t r = 0; r < capacities.size(); ++r) {
    average_usage_[r] += share * (answers.usage[r] - average_usage_[r]);
  }
  // Improvement: longer steps from here. kMaxFailedSteps without: shorter ones.
  if (value < bound()) {
    rows_part_ = rows;
    agents_part_ = std::move(agents);
    best_prices_ = prices_;
    failed_steps_ = 0;
    step_ = std::min(2.0, 1.2 * step_);
  } else if (++failed_steps_ >= kMaxFailedSteps) {
    failed_steps_ = 0;
    step_ = std::max(1e-3, 0.66 * step_);
  }
  bounds_.push_back(bound());
}

bool TeamPrices::settled() const {
  if (bounds_.size() <= kSettledRounds) return false;
  const double before = bounds_[bounds_.size() - 1 - kSettledRounds];
  return !(before - bounds_.back() > kSettledShare * std::abs(before));
}

void TeamPrices::Step(double plan) {
  double squared = 0.0;
  std::vector<double> excess(best_prices_.size());
  for (std::size_t r = 0; r < best_prices_.size(); ++r) {
    excess[r] = average_usage_[r] - capacities_[r];
    if (excess[r] < 0.0 && best_prices_[r] <= 0.0) excess[r] = 0.0;
    squared += excess[r] * excess[r];
  }
  prices_ = best_prices_;
  // Polyak step length: step * gap / |excess|^2.
  const double gap = std::min(bound() - plan, kLikelyGap * std::abs(bound()));
  if (!(squared > 0.0) || !std::isfinite(gap)) return;
  const double length = step_ * std::max(gap, 0.0) / squared;
  for (std::size_t r = 0; r < prices_.size(); ++r) {
    prices_[r] = std::max(0.0, best_prices_[r] + length * excess[r]);
  }
}

TeamPrices::Answers SummarizeAnswers(const TeamColumns& pool,
                                     const ColumnAnswers& answers) {
  TeamPrices::Answers summary;
  summary.bounds.assign(pool.agents(), 0.0);
  summary.usage.assign(pool.capacities().size(), 0);
  for (const auto& [agent, answer] : answers) {
    summary.bounds[agent] = answer.bound;
    if (answer.columns.empty()) continue;
    for (const int row : pool.columns()[answer.columns.front()].rows) {
      ++summary.usage[row];
    }
  }
  return summary;
}

}  // namespace kg_selector
