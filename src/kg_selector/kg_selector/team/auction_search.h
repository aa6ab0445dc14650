// Mode "auction": rows have prices that only rise. An agent without a column
// bids for its best one at the current prices; a full row goes to the bidder,
// the previous holder must bid again, and the price of the row rises by the
// bidder's advantage over its second choice, at least by epsilon [1].
//
// Termination: every bid for an occupied row raises its price by epsilon or
// more, and no agent bids more than it gains. So at most
//   agents + rows * (1 + range of scores / epsilon)
// bids are made; max_rounds may stop it earlier. It cannot cycle because prices
// never fall.
//
// Then all agents are asked at the final prices p: this gives the bound L(p) of
// team_prices.h. The holder of a column is within epsilon * (number of its
// rows) of its best at p, so unless max_rounds stopped the auction, the plan is
// within
//   sum over holders of epsilon * rows + sum of p_r * (places left in r)
// of the optimum. (With one row per agent this is Bertsekas' agents * epsilon;
// with paths of many rows, a released row may keep its price.) The reported
// bound is L(p), not this one.
//
// The plan is the better of the auction's and a greedy choice from the same
// columns, after Exchange(); group exchanges (group_exchange.h) improve it
// while they succeed and rounds are left. Paths that come too close without
// sharing a row have no price: the blocked agent plans around the other one.
//
// [1] D. P. Bertsekas, "The auction algorithm: a distributed relaxation method
//     for the assignment problem", Annals of Operations Research 14 (1988).

#ifndef KG_SELECTOR_TEAM_AUCTION_SEARCH_H_
#define KG_SELECTOR_TEAM_AUCTION_SEARCH_H_

#include <set>
#include <utility>
#include <vector>

#include "kg_selector/team/group_exchange.h"
#include "kg_selector/team/team_prices.h"
#include "kg_selector/team/team_search.h"

namespace kg_selector {

class AuctionSearch : public TeamSearch {
 public:
  explicit AuctionSearch(SearchOptions options) : options_(options) {}

  ColumnRequests Next(const TeamColumns& pool,
                      const ColumnAnswers& answers) override;
  void Drop(int agent) override;
  const TeamChoice& choice() const override { return best_; }
  double bound() const override { return relaxation_.bound(); }
  const std::vector<double>& prices() const override { return prices_; }

 private:
  enum class Phase { kBids, kFinal, kGroups, kUnserved };

  ColumnRequests AfterBids(const TeamColumns& pool,
                           const ColumnAnswers& answers);
  ColumnRequests AfterAuction(const TeamColumns& pool);
  ColumnRequests AfterGroups(const TeamColumns& pool,
                             const ColumnAnswers& answers);
  ColumnRequests RequestGroups(const TeamColumns& pool);
  ColumnRequests RequestUnserved();
  void ProcessBids(const TeamColumns& pool, const ColumnAnswers& answers);
  void ProcessBid(const TeamColumns& pool, int agent,
                  const ColumnAnswer& answer, std::set<int>* raised);
  std::vector<int> FullRows(const TeamColumns& pool, int column) const;
  bool IsBlocked(const TeamColumns& pool, int column);
  double Raise(const TeamColumns& pool, const ColumnAnswer& answer) const;
  ColumnRequests RequestBids(const TeamColumns& pool) const;
  void KeepIfBetter(const TeamColumns& pool, const TeamChoice& choice);

  SearchOptions options_;
  TeamPrices relaxation_;
  GroupExchange groups_;
  std::vector<double> prices_;
  TeamChoice held_;
  TeamChoice best_;
  std::set<int> retired_;  // Agents for which no column is worth its price.
  std::set<int> dropped_;
  std::set<std::pair<int, int>> blocked_;  // (agent, agent that blocks it)
  std::set<TeamChoice> asked_unserved_;
  Phase phase_ = Phase::kBids;
  int rounds_ = 0;
  int failed_waves_ = 0;
};

}  // namespace kg_selector

#endif  // KG_SELECTOR_TEAM_AUCTION_SEARCH_H_
