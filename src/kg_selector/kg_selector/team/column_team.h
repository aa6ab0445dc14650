// Coordinator of all modes with columns: answers become columns over the rows
// of team_rows.h, a TeamSearch makes the requests, and its choice is the plan.
// Apart from rows, two paths conflict if they come too close (conflict.h); with
// soft separation a pair costs SoftPenalty().
//
// For each agent that offered a path but got another, or none, its first
// favourite is among the rejections, with its conflict with the plan and the
// final prices of its rows.

#ifndef KG_SELECTOR_TEAM_COLUMN_TEAM_H_
#define KG_SELECTOR_TEAM_COLUMN_TEAM_H_

#include <map>
#include <memory>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "kg_selector/team/coordinator.h"
#include "kg_selector/team/team_rows.h"
#include "kg_selector/team/team_search.h"

namespace kg_selector {

class ColumnTeam : public Coordinator {
 public:
  ColumnTeam(TeamRules rules, const std::vector<std::string>& agents,
             std::unique_ptr<TeamSearch> search);
  ColumnTeam(const ColumnTeam&) = delete;
  ColumnTeam& operator=(const ColumnTeam&) = delete;

  void Offer(const std::string& agent, AgentOffer candidates) override;
  void Drop(const std::string& agent, const std::string& why) override;
  bool Advance() override;
  const std::set<std::string>& waiting_for() const override { return waiting_; }
  PlanRequest RequestFor(const std::string& agent) const override;
  // Until complete, nothing is committed.
  const TeamOutcome& outcome() const override { return outcome_; }

 private:
  int FindIndex(const std::string& agent) const;  // kNobody = unknown.
  ColumnAnswers CollectOffers();
  int FindOrAddColumn(int agent, Pathlet pathlet);
  void FindRows();
  bool TooClose(int a, int b);
  double FairnessLoad(const Pathlet& pathlet) const;
  void Finish();
  void RejectFavourites();

  TeamRules rules_;
  std::vector<std::string> names_;  // Ascending.
  TeamRows rows_;
  TeamColumns pool_;
  std::vector<Pathlet> pathlets_;  // Pathlet of each column.
  std::unique_ptr<TeamSearch> search_;

  std::set<std::string> waiting_;
  std::map<std::string, AgentOffer> offers_;  // Offers of the current round.
  ColumnRequests requests_;
  std::map<int, int> favourites_;  // Column by agent, of round 0.
  std::map<int, bool> refused_;    // True: all offers were rejected; by agent.
  std::unordered_map<std::size_t, bool> too_close_;  // By PairKey().
  TeamOutcome outcome_;
  int round_ = 0;
  bool finished_ = false;
};

}  // namespace kg_selector

#endif  // KG_SELECTOR_TEAM_COLUMN_TEAM_H_
