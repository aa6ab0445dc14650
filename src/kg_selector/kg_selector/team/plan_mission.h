// From a compilation to a team plan in one process: what the planner nodes and
// the selector node do together, for what-ifs, explanations and benchmarks.
// What comes out is what the nodes commit for the same compilation.

#ifndef KG_SELECTOR_TEAM_PLAN_MISSION_H_
#define KG_SELECTOR_TEAM_PLAN_MISSION_H_

#include <map>
#include <string>
#include <vector>

#include "kg_compiler/compile/mission_compiler.h"
#include "kg_selector/paths/walks.h"
#include "kg_selector/team/plan_team.h"

namespace kg_selector {

// Keeps what the plan was made from, so that others can ask about it. Agents
// are named by their ex:id.
struct PlannedMission {
  TeamRules rules;
  // In the order of the compilation's rules.
  std::vector<TeamMember> members;
  // Why an agent has no graphs, e.g. it starts on land. By ex:id.
  std::map<std::string, std::string> unplannable;
  // "graphs": waypoints and seams; "team": stitching and selection.
  std::map<std::string, double> stage_seconds;
  // What the next plan may take over, by ex:id. Shared by copies.
  std::map<std::string, GraphCache> caches;
  TeamPlan plan;

  // Null = not of the mission, or without a path.
  const TeamMember* FindMember(const std::string& agent) const;
  const Pathlet* FindPath(const std::string& agent) const;
};

// The team's rules as the selector node reads them; agents by their ex:id.
TeamRules ToTeamRules(const kg_compiler::Compilation& compilation);

// The rasters of `rules`, in the order of its windows. Throws std::logic_error
// if they are not of `compilation`.
std::vector<kg_compiler::WindowWorld> FindWorlds(
    const kg_compiler::Compilation& compilation,
    const kg_compiler::SeamRules& rules);

// Plans what `compilation` says, agents side by side on the machine's cores.
// What changes did not touch since `previous` (may be null) is taken over:
// graphs, arrival fields, flights, walks. The plan is the same without it.
PlannedMission PlanMission(const kg_compiler::Compilation& compilation,
                           const PlannedMission* previous);

}  // namespace kg_selector

#endif  // KG_SELECTOR_TEAM_PLAN_MISSION_H_
