// From the NavGraphs of all agents to a team plan in one process, as planner
// and selector nodes do together, for what-ifs and benchmarks.

#ifndef KG_SELECTOR_TEAM_PLAN_TEAM_H_
#define KG_SELECTOR_TEAM_PLAN_TEAM_H_

#include <map>
#include <string>
#include <vector>

#include "kg_compiler/control_plane/nav_graphs.h"
#include "kg_compiler/control_plane/seam_rules.h"
#include "kg_selector/paths/conflict.h"
#include "kg_selector/paths/pathlet.h"
#include "kg_selector/team/priced_replanning.h"
#include "kg_selector/team/team_plan.h"

namespace kg_selector {

struct TeamPlan : TeamOutcome {
  bool proven = true;  // Every path was proven best for its agent.
  // Last note of each agent without a path, if any.
  std::map<std::string, std::string> notes{};
  double score() const;
};

// Missing entries of rules.window_end_s are taken from the members.
TeamPlan PlanTeam(TeamRules rules, const std::vector<TeamMember>& members);

}  // namespace kg_selector

#endif  // KG_SELECTOR_TEAM_PLAN_TEAM_H_
