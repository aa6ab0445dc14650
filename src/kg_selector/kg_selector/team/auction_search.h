// Mode "auction": rows have prices that only rise. Whoever has no column bids
// for the best one at the prices; a row that is full goes to the bidder,
// whoever held it has to bid again, and the row gets dearer by the bidder's
// advantage over its second choice, and epsilon at least [1].
//
// It ends: every bid for what others hold raises a row by epsilon or more, and
// nobody bids for more than it gains. So at most
//   agents + rows * (1 + range of scores / epsilon)
// bids are made; max_rounds cuts that short. It cannot cycle: prices never
// fall.
//
// Then all are asked at the final prices p: that gives the bound L(p) of
// team_prices.h. Who holds a column is within epsilon * its rows of its best at
// p, so, if max_rounds did not cut, the plan is within
//   sum over holders of epsilon * rows + sum of p_r * (places left in r)
// of the best one. (For one row an agent that is Bertsekas' agents * epsilon;
// with paths of many rows, a row that was given up may be left with its price.)
// Printed is the bound found, not this one.
//
// The plan is the auction's, or what greedy choice gives from the same columns
// if that is worth more, after Exchange(); groups make it better as long as
// they can (group_exchange.h) and rounds are left. Paths that come too close
// without sharing a row have no price: who is in another's way like that plans
// around.
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
  std::set<std::pair<int, int>> blocked_;  // (agent, agent that is in its way).
  std::set<TeamChoice> asked_unserved_;
  Phase phase_ = Phase::kBids;
  int rounds_ = 0;
  int failed_waves_ = 0;
};

}  // namespace kg_selector

#endif  // KG_SELECTOR_TEAM_AUCTION_SEARCH_H_
