// The interface of every team mode: a state machine between the agents'
// planners, in any process, and the transport of messages. It takes every
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

  // No paths = none found. Replaces an earlier answer of an agent that is not
  // yet committed; ignored for agents that are committed, dropped or unknown.
  virtual void Offer(const std::string& agent, AgentOffer candidates) = 0;
  // Excludes an agent (dead, or past the deadline) from planning.
  virtual void Drop(const std::string& agent, const std::string& why) = 0;

  // Proceeds as far as possible. True when the plan is complete.
  virtual bool Advance() = 0;

  // Agents that must offer (again) before Advance() can proceed, and the
  // request for each.
  virtual const std::set<std::string>& waiting_for() const = 0;
  virtual PlanRequest RequestFor(const std::string& agent) const = 0;

  virtual const TeamOutcome& outcome() const = 0;
};

}  // namespace kg_selector

#endif  // KG_SELECTOR_TEAM_COORDINATOR_H_
