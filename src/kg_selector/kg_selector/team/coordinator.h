// The interface of every team mode: a state machine between the agents'
// planners, wherever they run, and whoever carries the messages. It takes every
// answer, and names the agents that must plan again, with their requests.
//
//   const auto team = MakeCoordinator(rules, {"a", "b", "c"});  // team_modes.h
//   team->Offer("a", offer_a); ...             // Round 0: without requests.
//   while (!team->Advance()) {
//     for (agent : copy of team->waiting_for())
//       team->Offer(agent, PlanPriced(rules, member, team->RequestFor(agent)));
//   }
//   team->outcome()
//
// The outcome does not depend on the order of answers within a round.

#ifndef KG_SELECTOR_TEAM_COORDINATOR_H_
#define KG_SELECTOR_TEAM_COORDINATOR_H_

#include <set>
#include <string>

#include "kg_selector/team/team_plan.h"

namespace kg_selector {

class Coordinator {
 public:
  virtual ~Coordinator() = default;

  // No paths: it found none. Replaces an earlier answer of an agent that is not
  // yet committed; ignored for one that is, was dropped or is unknown.
  virtual void Offer(const std::string& agent, AgentOffer candidates) = 0;
  // Gives up on an agent (dead, or past the deadline): planned without it.
  virtual void Drop(const std::string& agent, const std::string& why) = 0;

  // Goes on as far as it can. True when the plan is complete.
  virtual bool Advance() = 0;

  // Who must offer (again) before Advance() can go on, and under what.
  virtual const std::set<std::string>& waiting_for() const = 0;
  virtual PlanRequest RequestFor(const std::string& agent) const = 0;

  virtual const TeamOutcome& outcome() const = 0;
};

}  // namespace kg_selector

#endif  // KG_SELECTOR_TEAM_COORDINATOR_H_
