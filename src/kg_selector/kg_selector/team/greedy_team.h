// The paper's team coordination: commit the best path of all agents, mask what
// it rules out, let the others replan around it, repeat.
//
// The agents' planners do the planning, in any process, so this is a state
// machine: it takes every answer and returns the requests to plan again. The
// result does not depend on the order of answers. An agent whose best path has
// no conflict needs no new plan (masks only remove paths), so a team of A
// agents needs at most A rounds.
//
// Ties: the agent with the worse second choice goes first (scarcity), then by
// IRI. The second choice is the best other offered path without a conflict.
//
// Soft separation: an agent's favourite is its best offer by score -
// SoftPenalty() to the committed paths, and agents are ranked by that value.
// With hard separation the favourite is the offer with the best score.
//
// Every agent with a path gets one, even of negative value, because it must be
// somewhere. Therefore the bound counts 0 for an agent whose own bound is
// negative.
//
// A pending agent delays others only if its last offer, an upper bound of its
// next one, ranks at least as high as theirs. After rules.max_rounds the
// remaining agents are served from the paths offered so far.

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
  // Until complete: the plan so far.
  const TeamOutcome& outcome() const override { return outcome_; }

 private:
  struct Favourite {
    std::size_t index = 0;  // Index in the agent's offer.
    double value = 0.0;
  };
  double Value(const Pathlet& pathlet) const;
  Favourite FindFavourite(const std::vector<Pathlet>& offer) const;
  double SecondChoice(const std::vector<Pathlet>& offer,
                      std::size_t favourite) const;
  void RecordRejected();
  void DropAgentsWithoutPath();
  void RequestAgain();
  // The agent to commit next; empty = a pending agent must answer first.
  std::string Next() const;
  bool OutranksWaiting(double value) const;
  void Commit(const std::string& agent, std::size_t index);
  void CommitFromOffers();

  TeamRules rules_;
  // Offers of agents not yet committed.
  std::map<std::string, std::vector<Pathlet>> offers_;
  // Paths rejected by screening since the last Advance(), by agent.
  std::map<std::string, std::vector<RejectedPath>> rejected_;
  std::set<std::string> waiting_;
  std::map<std::string, double> bounds_;  // Bounds of round 0, by agent.
  TeamOutcome outcome_;
  int round_ = 0;  // Round of the offers awaited.
};

}  // namespace kg_selector

#endif  // KG_SELECTOR_TEAM_GREEDY_TEAM_H_
