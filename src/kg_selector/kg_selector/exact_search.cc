#include "kg_selector/exact_search.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "kg_selector/packing.h"

namespace kg_selector {
namespace {

// How close to its bound a plan need not be bettered.
constexpr double kNoGap = 1e-9;

double SecondsSince(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin)
      .count();
}

// Everything a choice may take, the pool's number of each column aside.
struct Problem {
  Packing packing;
  std::vector<int> pool_columns;
};

Problem ToProblem(const TeamColumns& pool) {
  Problem problem;
  problem.packing.agent_counts.assign(pool.agents(), 1);
  problem.packing.row_capacities = pool.capacities();
  problem.packing.fairness = pool.fairness;
  problem.packing.weight = pool.fairness_weight;
  for (int agent = 0; agent < pool.agents(); ++agent)
    for (const int c : pool.of_agent(agent)) {
      Column column = pool.columns()[c];
      column.score -= pool.unserved();
      column.load = pool.LoadOf(c);
      problem.packing.columns.push_back(std::move(column));
      problem.pool_columns.push_back(c);
    }
  return problem;
}

std::vector<int> ToStart(const Problem& problem, const TeamChoice& choice) {
  std::vector<int> start;
  for (std::size_t i = 0; i < problem.pool_columns.size(); ++i) {
    const int agent = problem.packing.columns[i].agent;
    if (choice[agent] == problem.pool_columns[i])
      start.push_back(static_cast<int>(i));
  }
  return start;
}

// Pairs of `chosen` that come too close; true if there are any.
bool AddConflicts(const TeamColumns& pool, const std::vector<int>& chosen,
                  Problem* problem) {
  bool any = false;
  for (std::size_t i = 0; i < chosen.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      if (!pool.Conflict(problem->pool_columns[chosen[k]],
                         problem->pool_columns[chosen[i]]))
        continue;
      problem->packing.conflicts.emplace_back(chosen[k], chosen[i]);
      any = true;
    }
  return any;
}

}  // namespace

ExactChoice ChooseExactly(const TeamColumns& pool, const TeamChoice& start,
                          double time_limit_s) {
  const auto begin = std::chrono::steady_clock::now();
  Problem problem = ToProblem(pool);
  PackingOptions options;
  options.start = ToStart(problem, start);
  while (true) {
    options.time_limit_s = time_limit_s - SecondsSince(begin);
    if (!(options.time_limit_s > 0.0)) return {start, false};
    const Chosen found = SolvePacking(problem.packing, options);
    if (AddConflicts(pool, found.chosen, &problem)) continue;
    ExactChoice exact{TeamChoice(pool.agents(), kNobody), found.optimal};
    for (const int i : found.chosen)
      exact.choice[problem.packing.columns[i].agent] = problem.pool_columns[i];
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

ColumnAsks ExactSearch::Next(const TeamColumns& pool,
                             const ColumnAnswers& answers) {
  if (!chosen_) {
    ColumnAsks asks = priced_.Next(pool, answers);
    if (!asks.empty()) return asks;
    chosen_ = true;
  }
  if (best_.empty()) best_ = priced_.choice();
  const ExactChoice exact = ChooseExactly(pool, best_, options_.time_limit_s);
  optimal_ = exact.optimal;
  const TeamChoice filled = Exchange(pool, prices(), exact.choice, {});
  if (IsMore(pool.Worth(filled), pool.Worth(best_))) best_ = filled;
  if (priced_.rounds() >= options_.max_rounds || asked_unserved_) return {};
  asked_unserved_ = true;
  return AskUnservedBeside(best_, dropped_);
}

}  // namespace kg_selector
