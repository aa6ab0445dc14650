// The paper's team coordination: the best path of all is committed, what it
// rules out is masked, the others plan again around it, and so on.
//
// Planning is done by the agents' planners, wherever they run, so this is a
// state machine: it takes every answer and returns the requests to plan again.
// The result does not depend on the order of answers. An agent whose best path
// conflicts with nobody needs no new plan (masks only take paths away), so a
// team of A agents needs at most A rounds.
//
// Ties: the agent whose second choice is worse goes first (scarcity), then IRI.
// A second choice is the best other path offered that conflicts with nobody.
//
// Soft separation: an agent's favourite is the best of what it offered by score
// minus SoftPenalty() to those committed, and agents are ranked by that. With
// hard separation the favourite is simply the best.
//
// Every agent that has a path gets one, even if its value is negative: an agent
// must be somewhere. So the bound counts 0 for an agent whose own is negative.
//
// An agent that waits keeps others back only if its last offer, which its next
// cannot beat, ranks as high as theirs. After rules.max_rounds the rest is
// chosen from what has been offered.

#ifndef KG_SELECTOR_TEAM_GREEDY_TEAM_H_
#define KG_SELECTOR_TEAM_GREEDY_TEAM_H_

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "kg_selector/paths/conflict.h"
#include "kg_selector/paths/pathlet.h"
#include "kg_selector/team/coordinator.h"

namespace kg_selector {

class GreedyTeam : public Coordinator {
 public:
  GreedyTeam(TeamRules rules, std::vector<std::string> agents);

  void Offer(const std::string& agent, AgentOffer candidates) override;
  void Drop(const std::string& agent, const std::string& why) override;
  // Commits what can be committed.
  bool Advance() override;
  const std::set<std::string>& waiting_for() const override { return waiting_; }
  PlanRequest RequestFor(const std::string& agent) const override;
  // While it goes on: the plan so far.
  const TeamOutcome& outcome() const override { return outcome_; }

 private:
  struct Favourite {
    std::size_t index = 0;  // In the agent's offer.
    double value = 0.0;
  };
  double Value(const Pathlet& pathlet) const;
  Favourite FindFavourite(const std::vector<Pathlet>& offer) const;
  double SecondChoice(const std::vector<Pathlet>& offer,
                      std::size_t favourite) const;
  void RecordRejected();
  void DropAgentsWithoutPath();
  void RequestAgain();
  // The agent to commit next; empty if one must be waited for first.
  std::string Next() const;
  bool OutranksWaiting(double value) const;
  void Commit(const std::string& agent, std::size_t index);
  void CommitFromOffers();

  TeamRules rules_;
  std::map<std::string, std::vector<Pathlet>> offers_;  // Not committed.
  // Paths that screening rejected since the last Advance(), by agent.
  std::map<std::string, std::vector<RejectedPath>> rejected_;
  std::set<std::string> waiting_;
  std::map<std::string, double> bounds_;  // Of round 0, by agent.
  TeamOutcome outcome_;
  int round_ = 0;  // The one offers are wanted for.
};

}  // namespace kg_selector

#endif  // KG_SELECTOR_TEAM_GREEDY_TEAM_H_
