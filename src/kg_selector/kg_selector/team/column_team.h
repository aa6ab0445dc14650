// Every mode with columns, as the team sees it: answers become columns over the
// rows of team_rows.h, a TeamSearch makes the requests, and what it chooses is
// the plan. Beyond rows two paths conflict if they come too close
// (conflict.h); where separation is soft a pair costs SoftPenalty().
//
// Who offered a path but got another, or none, has its first favourite among
// the rejections: with the conflict it has with the plan, and what its rows
// cost at the end.

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
  // Before the end: nothing is committed.
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
  std::vector<Pathlet> pathlets_;  // By column.
  std::unique_ptr<TeamSearch> search_;

  std::set<std::string> waiting_;
  std::map<std::string, AgentOffer> offers_;  // Of the current round.
  ColumnRequests requests_;
  std::map<int, int> favourites_;  // Column by agent, of round 0.
  std::map<int, bool> refused_;    // Whether all it offered was rejected.
  std::unordered_map<std::size_t, bool> too_close_;  // By pair of columns.
  TeamOutcome outcome_;
  int round_ = 0;
  bool finished_ = false;
};

}  // namespace kg_selector

#endif  // KG_SELECTOR_TEAM_COLUMN_TEAM_H_
