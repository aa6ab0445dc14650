#include "kg_selector/team/exact_search.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "kg_base/common/stopwatch.h"
#include "kg_selector/packing/packing.h"

namespace kg_selector {
namespace {

// Relative gap below which a plan is optimal.
constexpr double kNoGap = 1e-9;
// Pool size up to which all pairs are checked for conflicts at once.
constexpr int kFewColumns = 300;

// Everything a choice may take, the pool's number of each column aside.
struct ChoiceProblem {
  Packing packing;
  std::vector<int> pool_columns;
};

// Reduced cost fixing: true if a plan with the column could still beat `start`
// under these prices, i.e. its loss against the agent's best reduced value is
// at most the gap to the relaxation.
class ColumnFilter {
 public:
  ColumnFilter(const TeamColumns& pool, const std::vector<double>& prices,
               const TeamChoice& start)
      : pool_(pool), prices_(prices) {
    for (std::size_t r = 0; r < prices.size(); ++r) {
      gap_ += prices[r] * pool.capacities()[r];
    }
    for (int agent = 0; agent < pool.agents(); ++agent) {
      double best = pool.columns_of(agent).empty() ? 0.0 : pool.unserved();
      for (const int column : pool.columns_of(agent)) {
        best = std::max(best, pool.Reduced(column, prices));
      }
      best_.push_back(best);
      gap_ += best;
    }
    gap_ -= pool.Worth(start).second;
  }
  bool operator()(int column) const {
    if (pool_.fairness != Fairness::kNone) return true;
    const double forgone =
        best_[pool_.columns()[column].agent] - pool_.Reduced(column, prices_);
    return !(forgone > gap_ + kNoGap * (1.0 + std::abs(gap_)));
  }

 private:
  const TeamColumns& pool_;
  const std::vector<double>& prices_;
  std::vector<double> best_;  // Best reduced value, by agent.
  double gap_ = 0.0;          // Value of the relaxation - value of `start`.
};

ChoiceProblem ToProblem(const TeamColumns& pool, const ColumnFilter& filter,
                        const TeamChoice& start) {
  ChoiceProblem problem;
  problem.packing.agent_counts.assign(pool.agents(), 1);
  problem.packing.row_capacities = pool.capacities();
  problem.packing.fairness = pool.fairness;
  problem.packing.weight = pool.fairness_weight;
  for (int agent = 0; agent < pool.agents(); ++agent) {
    for (const int c : pool.columns_of(agent)) {
      if (start[agent] != c && !filter(c)) continue;
      Column column = pool.columns()[c];
      column.score -= pool.unserved();
      column.load = pool.FairnessLoad(c);
      problem.packing.columns.push_back(std::move(column));
      problem.pool_columns.push_back(c);
    }
  }
  return problem;
}

std::vector<int> ToStart(const ChoiceProblem& problem,
                         const TeamChoice& choice) {
  std::vector<int> start;
  for (std::size_t i = 0; i < problem.pool_columns.size(); ++i) {
    const int agent = problem.packing.columns[i].agent;
    if (choice[agent] == problem.pool_columns[i]) {
      start.push_back(static_cast<int>(i));
    }
  }
  return start;
}

// Adds pairs of `chosen` that come too close; true if there are any.
bool AddConflicts(const TeamColumns& pool, const std::vector<int>& chosen,
                  ChoiceProblem* problem) {
  bool any = false;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (!pool.Conflict(problem->pool_columns[chosen[k]],
                         problem->pool_columns[chosen[i]])) {
        continue;
      }
      problem->packing.conflicts.emplace_back(chosen[k], chosen[i]);
      any = true;
    }
  }
  return any;
}

// Adds all pairs that come too close, for small pools.
void AddAllConflicts(const TeamColumns& pool, ChoiceProblem* problem) {
  const int count = static_cast<int>(problem->pool_columns.size());
  if (count > kFewColumns) return;
  for (int i = 0; i < count; ++i) {
    for (int k = 0; k < i; ++k) {
      if (problem->packing.columns[i].agent !=
              problem->packing.columns[k].agent &&
          pool.Conflict(problem->pool_columns[k], problem->pool_columns[i])) {
        problem->packing.conflicts.emplace_back(k, i);
      }
    }
  }
}

}  // namespace

ExactChoice ChooseExactly(const TeamColumns& pool, const TeamChoice& start,
                          const std::vector<double>& prices,
                          double time_limit_s) {
  const kg_base::Stopwatch watch;
  ChoiceProblem problem =
      ToProblem(pool, ColumnFilter(pool, prices, start), start);
  if (ToStart(problem, start).size() == problem.pool_columns.size()) {
    return {start, true};
  }
  // Distance conflicts are expensive to find: all pairs only for small pools,
  // otherwise those of each solution until it has none (lazy constraints).
  AddAllConflicts(pool, &problem);
  PackingOptions options;
  options.start = ToStart(problem, start);
  while (true) {
    options.time_limit_s = time_limit_s - watch.Elapsed_s();
    if (!(options.time_limit_s > 0.0)) return {start, false};
    const PackingChoice found = SolvePacking(problem.packing, options);
    if (AddConflicts(pool, found.chosen, &problem)) continue;
    ExactChoice exact{TeamChoice(pool.agents(), kNobody), found.optimal};
    for (const int i : found.chosen) {
      exact.choice[problem.packing.columns[i].agent] = problem.pool_columns[i];
    }
    return exact;
  }
}

ExactSearch::ExactSearch(const SearchOptions& options)
    : options_(options), priced_([&] {
        SearchOptions closer = options;
        closer.gap_goal = kNoGap;
        return closer;
      }()) {}

void ExactSearch::Drop(int agent) {
  dropped_.insert(agent);
  priced_.Drop(agent);
  if (!best_.empty()) best_[agent] = kNobody;
}

ColumnRequests ExactSearch::Next(const TeamColumns& pool,
                                 const ColumnAnswers& answers) {
  if (!chosen_) {
    ColumnRequests requests = priced_.Next(pool, answers);
    if (!requests.empty()) return requests;
    chosen_ = true;
  }
  if (best_.empty()) best_ = priced_.choice();
  const ExactChoice exact =
      ChooseExactly(pool, best_, prices(), options_.time_limit_s);
  const TeamChoice filled = Exchange(pool, prices(), exact.choice, {});
  if (IsMore(pool.Worth(filled), pool.Worth(best_))) best_ = filled;
  if (priced_.rounds() >= options_.max_rounds || asked_unserved_) return {};
  asked_unserved_ = true;
  return RequestUnservedBeside(best_, dropped_);
}

}  // namespace kg_selector
