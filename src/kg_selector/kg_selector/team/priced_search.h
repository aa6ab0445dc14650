// Mode "priced": all agents plan under common prices of scarce rows, which rise
// where demand exceeds capacity (team_prices.h), until the gap between plan and
// bound is small enough.
//
// 1. Prices. All agents are asked under the prices, until these settle or half
// of
//    the rounds are used. Few of the answers then still conflict.
// 2. Repair. Agents that lost a row are asked again at the same prices, around
//    the others, until every agent has a path or none is left.
// 3. Groups replan around the others (group_exchange.h), wave by wave.
// 4. Agents without a path are asked for one around the plan.
// After each round Exchange() over all columns so far; the best plan is kept.
//
// Rounds are bounded by max_rounds, and only a better plan replaces the best:
// no sequence of plans can come back to one that was left.

#ifndef KG_SELECTOR_TEAM_PRICED_SEARCH_H_
#define KG_SELECTOR_TEAM_PRICED_SEARCH_H_

#include <set>
#include <utility>
#include <vector>

#include "kg_selector/team/group_exchange.h"
#include "kg_selector/team/team_prices.h"
#include "kg_selector/team/team_search.h"

namespace kg_selector {

class PricedSearch : public TeamSearch {
 public:
  explicit PricedSearch(SearchOptions options) : options_(options) {}

  ColumnRequests Next(const TeamColumns& pool,
                      const ColumnAnswers& answers) override;
  void Drop(int agent) override;
  const TeamChoice& choice() const override { return best_; }
  double bound() const override { return prices_.bound(); }
  const std::vector<double>& prices() const override {
    return prices_.best_prices();
  }
  int rounds() const { return rounds_; }

 private:
  enum class Phase { kPrices, kRepair, kGroups, kUnserved };

  void FitColumns(const TeamColumns& pool, const ColumnAnswers& answers);
  void KeepIfBetter(const TeamColumns& pool, TeamChoice choice, int columns);
  bool IsCloseEnough(const TeamColumns& pool) const;
  ColumnRequests AfterPrices(const TeamColumns& pool,
                             const ColumnAnswers& answers);
  ColumnRequests AfterRepair(const TeamColumns& pool,
                             const ColumnAnswers& answers);
  ColumnRequests AfterGroups(const TeamColumns& pool,
                             const ColumnAnswers& answers);
  ColumnRequests RequestAtPrices(const TeamColumns& pool);
  ColumnRequests RequestGroups(const TeamColumns& pool);
  ColumnRequests RequestUnserved();

  SearchOptions options_;
  TeamPrices prices_;
  GroupExchange groups_;
  TeamChoice best_;
  TeamChoice current_;       // Start of the next wave of groups.
  TeamChoice partial_;       // Columns kept by the current repair.
  std::set<int> displaced_;  // Agents to ask in the current repair.
  std::set<int> dropped_;
  std::set<TeamChoice> asked_unserved_;  // Plans for which step 4 was done.
  Phase phase_ = Phase::kPrices;
  int rounds_ = 0;
};

}  // namespace kg_selector

#endif  // KG_SELECTOR_TEAM_PRICED_SEARCH_H_
