// All offers of the agents, as columns over rows, and the choice of one
// column an agent. Knows neither missions nor planners: missions and benchmarks
// have it in common.
//
//   maximise  sum of score_c - sum of penalty_cd over pairs chosen
//   such that every row has at most its capacity of users, and no pair
//   conflicts
//
// An agent without a column counts unserved(): the worst score on offer, at
// most 0. So it never pays to leave out an agent that could be served, and a
// plan in which every agent has a column is worth the sum of their scores.

#ifndef KG_SELECTOR_TEAM_TEAM_COLUMNS_H_
#define KG_SELECTOR_TEAM_TEAM_COLUMNS_H_

#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "kg_selector/packing/packing.h"

namespace kg_selector {

constexpr int kNobody = -1;

// By agent: its column, or kNobody.
using TeamChoice = std::vector<int>;

// What a choice is worth: the first counts, the second breaks ties.
struct TeamWorth {
  double first = 0.0;
  double second = 0.0;
};
bool IsMore(const TeamWorth& a, const TeamWorth& b);  // By more than rounding.

class TeamColumns {
 public:
  explicit TeamColumns(int agents) : of_agent_(agents) {}

  int AddRow(int capacity);
  int Add(Column column);
  // The one of the same agent and rows if there is one, else added.
  int AddIfNew(Column column);
  // Rows may be found out after a column was added. Ascending.
  void SetRows(int column, std::vector<int> rows);
  void Drop(int agent);  // Its columns are not chosen any more.

  // Between two columns of distinct agents, beyond rows. Empty = never; 0.
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

  double Score(const TeamChoice& choice) const;  // Sum, less penalties.
  TeamWorth Worth(const TeamChoice& choice) const;
  bool IsAllowed(const TeamChoice& choice) const;
  bool Conflict(int a, int b) const { return conflict && conflict(a, b); }
  double Penalty(int a, int b) const { return penalty ? penalty(a, b) : 0.0; }
  // The load that fairness compares; for kMaxMin the score beyond unserved().
  double FairnessLoad(int column) const;
  // The score less the prices of its rows.
  double Reduced(int column, const std::vector<double>& prices) const;

 private:
  std::vector<int> capacities_;
  std::vector<Column> columns_;
  std::vector<std::vector<int>> of_agent_;
  std::map<std::pair<int, std::vector<int>>, int> by_rows_;
  double unserved_ = 0.0;
};

// Best first by reduced value, whoever fits; ties by agent, then column.
TeamChoice ChooseGreedily(const TeamColumns& pool,
                          const std::vector<double>& prices);

struct ExchangeOptions {
  int columns = 60;  // Tried for each agent, the best under prices.
  int passes = 20;
};
// A column for what is in its way, and a new one for each agent so ousted, as
// long as that is worth more. Everybody who fits is served. Never worse than
// `choice`.
TeamChoice Exchange(const TeamColumns& pool, const std::vector<double>& prices,
                    TeamChoice choice, const ExchangeOptions& options);

}  // namespace kg_selector

#endif  // KG_SELECTOR_TEAM_TEAM_COLUMNS_H_
