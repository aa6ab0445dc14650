// How a mode with columns searches for a team plan, in columns over rows: the
// part of it that knows neither missions nor messages. Rounds of requests:
//
//   requests = search.Next(round)         // Round 0: all agents, no request.
//   for (agent, request : requests)       // None = done: search.choice().
//     the best columns of `agent` under the prices of `request.prices`, beside
//     the columns `request.around`, go to the pool and into the next round
//
// Answers of one round are taken together, by agent: the order in which they
// come does not matter.

#ifndef KG_SELECTOR_TEAM_TEAM_SEARCH_H_
#define KG_SELECTOR_TEAM_TEAM_SEARCH_H_

#include <limits>
#include <map>
#include <set>
#include <vector>

#include "kg_selector/team/team_columns.h"

namespace kg_selector {

// Columns of one agent that are allowed beside `around` (neither their rows
// overfull nor in conflict), the best by score less prices.
struct ColumnRequest {
  std::vector<double> prices;  // By row; rows beyond cost nothing.
  std::vector<int> around;     // Columns of others.
};

struct ColumnAnswer {
  std::vector<int> columns;  // In the pool, best first, prices counted.
  // Upper bound of the value of any column beside those of the request, less
  // prices.
  double bound = std::numeric_limits<double>::quiet_NaN();  // NaN = not known.
};

// By agent: those that were asked, and answered.
using ColumnAnswers = std::map<int, ColumnAnswer>;
using ColumnRequests = std::map<int, ColumnRequest>;

class TeamSearch {
 public:
  virtual ~TeamSearch() = default;

  // Takes the answers to the last requests; returns the next ones. Rows may
  // have been added to the pool since. No more than a number of rounds that the
  // mode states.
  virtual ColumnRequests Next(const TeamColumns& pool,
                              const ColumnAnswers& answers) = 0;
  virtual void Drop(int agent) = 0;

  // The best plan so far, and what no plan is worth more than.
  virtual const TeamChoice& choice() const = 0;
  virtual double bound() const = 0;
  // Final price of each row.
  virtual const std::vector<double>& prices() const = 0;
};

struct SearchOptions {
  int max_rounds = 8;  // Of asking, the first included.
  double gap_goal = 0.01;
  double epsilon = 0.05;      // Least raise of a price.
  double time_limit_s = 2.0;  // Of the exact choice [s].
};

// The columns that are chosen.
std::vector<int> ChosenColumns(const TeamChoice& choice);
// Requests for every agent without a column: its best one beside all columns
// that are chosen.
ColumnRequests RequestUnservedBeside(const TeamChoice& choice,
                                     const std::set<int>& dropped);
// Requests for all agents, at the same prices.
ColumnRequests RequestAll(const std::vector<double>& prices, int agents,
                          const std::set<int>& dropped);

}  // namespace kg_selector

#endif  // KG_SELECTOR_TEAM_TEAM_SEARCH_H_
