// Data exchanged between a team and its agents during planning, and the result:
// offers, requests, rejected paths, the outcome. Scores, prices and bounds are
// in reward units.

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

// One agent's answer to a request.
struct AgentOffer {
  std::vector<Pathlet> pathlets;  // Best first (prices included); at most K.
  bool proven = true;
  std::string note = {};  // One line: why there is no path, or "".

  // Upper bound of score - prices over paths that satisfy the request.
  double bound = std::numeric_limits<double>::quiet_NaN();  // NaN = not known.
};

struct WaypointPrice {
  int window = 0;
  int waypoint = 0;    // Id in the agent's own NavGraph of that window.
  double price = 0.0;  // >= 0; paid if the window ends there.
};

// Conditions under which one agent plans.
struct PlanRequest {
  std::vector<Pathlet> around;        // Committed paths; only tracks are read.
  std::set<std::string> full_events;  // Visits earn no event reward there.
  std::vector<WaypointPrice> waypoint_prices;
  // Paid once if the event is earned.
  std::map<std::string, double> event_prices;
};

// A request around the committed paths, without prices.
PlanRequest RequestAround(const TeamRules& rules,
                          const std::vector<Pathlet>& committed);

struct RejectedPath {
  Pathlet pathlet;
  Conflict conflict;   // Meaningful unless reason says otherwise.
  std::string reason;  // Display text, one line.
  int round = 0;
};

struct TeamOutcome {
  std::vector<Pathlet> committed;  // In order of commitment.
  std::vector<RejectedPath> rejections;
  // Agents that got no path, with the reason.
  std::map<std::string, std::string> unassigned;
  int rounds = 1;  // Planning rounds, the first included.
  // Upper bound of reward - seam cost of any plan of this team; NaN = unknown.
  double bound = std::numeric_limits<double>::quiet_NaN();
};

}  // namespace kg_selector

#endif  // KG_SELECTOR_TEAM_TEAM_PLAN_H_
