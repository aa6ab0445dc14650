// Search of a mode with columns for a team plan, in columns over rows,
// independent of missions and messages. Rounds of requests:
//
//   requests = search.Next(round)         // Round 0: all agents, no request.
//   for (agent, request : requests)       // None = done: search.choice().
//     the best columns of `agent` under the prices of `request.prices`, beside
//     the columns `request.around`, go to the pool and into the next round
//
// Answers of one round are processed together, by agent, so their order of
// arrival does not matter.

#ifndef KG_SELECTOR_TEAM_TEAM_SEARCH_H_
#define KG_SELECTOR_TEAM_TEAM_SEARCH_H_

#include <limits>
#include <map>
#include <set>
#include <vector>

#include "kg_selector/team/team_columns.h"

namespace kg_selector {

// Request for the best columns of one agent, by score - prices, that are
// feasible beside `around` (no row overfull, no conflict).
struct ColumnRequest {
  std::vector<double> prices;  // Price by row; missing rows have price 0.
  std::vector<int> around;     // Columns of other agents.
};

struct ColumnAnswer {
  // Indices into the pool, best first, prices included.
  std::vector<int> columns;
  // Upper bound of score - prices of any column feasible beside the request's.
  double bound = std::numeric_limits<double>::quiet_NaN();  // NaN = not known.
};

// By agent: the agents that were asked, and answered.
using ColumnAnswers = std::map<int, ColumnAnswer>;
using ColumnRequests = std::map<int, ColumnRequest>;

class TeamSearch {
 public:
  virtual ~TeamSearch() = default;

  // Takes the answers to the last requests; returns the next ones. The pool may
  // have gained rows since. The number of rounds is bounded by the mode.
  virtual ColumnRequests Next(const TeamColumns& pool,
                              const ColumnAnswers& answers) = 0;
  virtual void Drop(int agent) = 0;

  // The best plan so far, and an upper bound of any plan.
  virtual const TeamChoice& choice() const = 0;
  virtual double bound() const = 0;
  // Final price of each row.
  virtual const std::vector<double>& prices() const = 0;
};

struct SearchOptions {
  int max_rounds = 8;  // Request rounds, the first included.
  double gap_goal = 0.01;
  double epsilon = 0.05;      // Minimum price increment [reward].
  double time_limit_s = 2.0;  // Time limit of the exact choice [s].
};

// Chosen columns.
std::vector<int> ChosenColumns(const TeamChoice& choice);
// Requests for every agent without a column: its best one beside all chosen
// columns.
ColumnRequests RequestUnservedBeside(const TeamChoice& choice,
                                     const std::set<int>& dropped);
// Requests for all agents at the same prices.
ColumnRequests RequestAll(const std::vector<double>& prices, int agents,
                          const std::set<int>& dropped);

}  // namespace kg_selector

#endif  // KG_SELECTOR_TEAM_TEAM_SEARCH_H_
