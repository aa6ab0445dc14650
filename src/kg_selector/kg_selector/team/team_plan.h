// What a team and its agents exchange while a plan is made, and the plan that
// comes out: offers, requests, rejected paths, the outcome. Scores, prices and
// bounds in reward units.

#ifndef KG_SELECTOR_TEAM_TEAM_PLAN_H_
#define KG_SELECTOR_TEAM_TEAM_PLAN_H_

#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "kg_selector/paths/conflict.h"
#include "kg_selector/paths/pathlet.h"

namespace kg_selector {

// One agent's answer.
struct AgentOffer {
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
struct PlanRequest {
  std::vector<Pathlet> around;        // Committed; only tracks are read.
  std::set<std::string> full_events;  // A visit earns nothing there.
  std::vector<WaypointPrice> waypoint_prices;
  std::map<std::string, double> event_prices;  // Paid once, if it is earned.
};

// Around those committed, without prices.
PlanRequest RequestAround(const TeamRules& rules,
                          const std::vector<Pathlet>& committed);

struct RejectedPath {
  Pathlet pathlet;
  Conflict conflict;   // Meaningful unless reason says otherwise.
  std::string reason;  // One line for a person.
  int round = 0;
};

struct TeamOutcome {
  std::vector<Pathlet> committed;  // In order of commitment.
  std::vector<RejectedPath> rejections;
  // Agents that got no path, with the reason.
  std::map<std::string, std::string> unassigned;
  int rounds = 1;  // Of planning, the first included.
  // No plan of this team is worth more, reward - seam cost; NaN = not known.
  double bound = std::numeric_limits<double>::quiet_NaN();
};

}  // namespace kg_selector

#endif  // KG_SELECTOR_TEAM_TEAM_PLAN_H_
