// How a team plan comes about, whatever the mode: a state machine between the
// agents' planners, wherever they run, and whoever carries the messages. Hand
// it every answer; it says who must plan again, and under what.
//
//   const auto team = MakeCoordinator(rules, {"a", "b", "c"});
//   team->Offer("a", candidates_a); ...        // Round 0: nothing asked.
//   while (!team->Advance()) {
//     for (agent : copy of team->waiting_for())
//       team->Offer(agent, PlanUnder(rules, member, team->AskOf(agent)));
//   }
//   team->outcome()
//
// The outcome does not depend on the order of answers within a round.

#ifndef KG_SELECTOR_TEAM_COORDINATOR_H_
#define KG_SELECTOR_TEAM_COORDINATOR_H_

#include <limits>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "kg_selector/paths/conflict.h"
#include "kg_selector/paths/pathlet.h"

namespace kg_selector {

// One agent's answer.
struct Candidates {
  std::vector<Pathlet> pathlets;  // Best first, prices counted; at most K.
  bool proven = true;
  std::string note = {};  // One line; why there is no path, or "".

  // No path that keeps to what was asked is worth more, prices taken off.
  double bound = std::numeric_limits<double>::quiet_NaN();  // NaN = not known.
};

struct WaypointPrice {
  int window = 0;
  int waypoint = 0;    // Id in the agent's own NavGraph of that window.
  double price = 0.0;  // >= 0; paid if the window ends there.
};

// What one agent is to plan under.
struct Ask {
  std::vector<Pathlet> around;        // Committed; only tracks are read.
  std::set<std::string> full_events;  // A visit earns nothing there.
  std::vector<WaypointPrice> waypoint_prices;
  std::map<std::string, double> event_prices;  // Paid once, if it is earned.
};

// Around those committed, without prices.
Ask AskAround(const TeamRules& rules, const std::vector<Pathlet>& committed);

struct Rejection {
  Pathlet pathlet;
  Conflict conflict;   // Meaningful unless reason says otherwise.
  std::string reason;  // One line for a person.
  int round = 0;
};

struct TeamOutcome {
  std::vector<Pathlet> committed;  // In order of commitment.
  std::vector<Rejection> rejections;
  // Agents that got no path, with the reason.
  std::map<std::string, std::string> unassigned;
  int rounds = 1;  // Of planning, the first included.
  // No plan of this team is worth more, reward - seam cost; NaN = not known.
  double bound = std::numeric_limits<double>::quiet_NaN();
};

class Coordinator {
 public:
  virtual ~Coordinator() = default;

  // No paths: it found none. Replaces an earlier answer of an agent that is not
  // yet committed; ignored for one that is, was dropped or is unknown.
  virtual void Offer(const std::string& agent, Candidates candidates) = 0;
  // Gives up on an agent (dead, or past the deadline): planned without it.
  virtual void Drop(const std::string& agent, const std::string& why) = 0;

  // Goes on as far as it can. True when nobody is waited for any more.
  virtual bool Advance() = 0;

  // Who must offer (again) before Advance() can go on, and under what.
  virtual const std::set<std::string>& waiting_for() const = 0;
  virtual Ask AskOf(const std::string& agent) const = 0;

  virtual const TeamOutcome& outcome() const = 0;
};

// By rules.mode. Throws kg_core::InputError for another one.
std::unique_ptr<Coordinator> MakeCoordinator(const TeamRules& rules,
                                             std::vector<std::string> agents);

}  // namespace kg_selector

#endif  // KG_SELECTOR_TEAM_COORDINATOR_H_
