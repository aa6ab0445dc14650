// All offers of the agents as columns over rows, and the choice of one column
// per agent. Independent of missions and planners; used by missions and
// benchmarks alike.
//
//   maximise  sum of score_c - sum of penalty_cd over pairs chosen
//   such that every row has at most its capacity of users, and no pair
//   conflicts
//
// An agent without a column counts unserved(): the worst score on offer, at
// most 0. So leaving out an agent that could be served never pays, and a plan
// in which every agent has a column is worth the sum of their scores.

#ifndef KG_SELECTOR_TEAM_TEAM_COLUMNS_H_
#define KG_SELECTOR_TEAM_TEAM_COLUMNS_H_

#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "kg_selector/packing/packing.h"

namespace kg_selector {

constexpr int kNobody = -1;

// Chosen column by agent, or kNobody.
using TeamChoice = std::vector<int>;

// Lexicographic value of a choice: `second` breaks ties of `first`.
struct TeamWorth {
  double first = 0.0;
  double second = 0.0;
};
// True if a > b by more than rounding.
bool IsMore(const TeamWorth& a, const TeamWorth& b);

class TeamColumns {
 public:
  explicit TeamColumns(int agents) : of_agent_(agents) {}

  int AddRow(int capacity);
  int Add(Column column);
  // Index of the column with the same agent and rows; added if missing.
  int AddIfNew(Column column);
  // Sets rows found after a column was added; ascending.
  void SetRows(int column, std::vector<int> rows);
  void Drop(int agent);  // Excludes the agent's columns from choices.

  // Conflict and penalty between two columns of distinct agents, apart from
  // rows. Empty function = no conflict, penalty 0.
  std::function<bool(int, int)> conflict;
  std::function<double(int, int)> penalty;
  Fairness fairness = Fairness::kNone;
  double fairness_weight = 0.0;

  int agents() const { return static_cast<int>(of_agent_.size()); }
  const std::vector<int>& capacities() const { return capacities_; }
  const std::vector<Column>& columns() const { return columns_; }
  const std::vector<int>& columns_of(int agent) const {
    return of_agent_[agent];
  }
  double unserved() const { return unserved_; }

  double Score(const TeamChoice& choice) const;  // Sum of scores - penalties.
  TeamWorth Worth(const TeamChoice& choice) const;
  bool IsAllowed(const TeamChoice& choice) const;
  bool Conflict(int a, int b) const { return conflict && conflict(a, b); }
  double Penalty(int a, int b) const { return penalty ? penalty(a, b) : 0.0; }
  // Load compared for fairness; for kMaxMin the score above unserved().
  double FairnessLoad(int column) const;
  // Score minus the prices of the column's rows.
  double Reduced(int column, const std::vector<double>& prices) const;

 private:
  std::vector<int> capacities_;
  std::vector<Column> columns_;
  std::vector<std::vector<int>> of_agent_;
  std::map<std::pair<int, std::vector<int>>, int> by_rows_;
  double unserved_ = 0.0;
};

// Greedy by reduced value, skipping columns that do not fit; ties by agent,
// then column.
TeamChoice ChooseGreedily(const TeamColumns& pool,
                          const std::vector<double>& prices);

struct ExchangeOptions {
  int columns = 60;  // Columns tried per agent, the best under prices.
  int passes = 20;
};
// Local search: replaces the columns that block a column by it, and gives each
// displaced agent a new one, while the worth increases. Agents that fit are
// served first. Never worse than `choice`.
TeamChoice Exchange(const TeamColumns& pool, const std::vector<double>& prices,
                    TeamChoice choice, const ExchangeOptions& options);

}  // namespace kg_selector

#endif  // KG_SELECTOR_TEAM_TEAM_COLUMNS_H_
