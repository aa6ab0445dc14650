// From a compilation to a team plan in one process, as the planner and selector
// nodes do together, for what-ifs, explanations and benchmarks. The result
// equals what the nodes commit for the same compilation.

#ifndef KG_SELECTOR_TEAM_PLAN_MISSION_H_
#define KG_SELECTOR_TEAM_PLAN_MISSION_H_

#include <map>
#include <string>
#include <vector>

#include "kg_compiler/compile/mission_compiler.h"
#include "kg_selector/paths/walks.h"
#include "kg_selector/team/plan_team.h"

namespace kg_selector {

// A plan with its inputs, for later questions about it. Agents are named by
// their ex:id.
struct PlannedMission {
  TeamRules rules;
  // In the order of the compilation's rules.
  std::vector<TeamMember> members;
  // Reason why an agent has no graphs, e.g. it starts on land; by ex:id.
  std::map<std::string, std::string> unplannable;
  // "graphs": waypoints and seams; "team": stitching and selection.
  std::map<std::string, double> stage_seconds;
  // Data the next plan may reuse, by ex:id. Shared by copies.
  std::map<std::string, GraphCache> caches;
  TeamPlan plan;

  // Null = not in the mission, or without a path.
  const TeamMember* FindMember(const std::string& agent) const;
  const Pathlet* FindPath(const std::string& agent) const;
};

// The team's rules as the selector node reads them; agents by ex:id.
TeamRules ToTeamRules(const kg_compiler::Compilation& compilation);

// The rasters of `rules`, in the order of its windows. Throws std::logic_error
// if `compilation` does not contain them.
std::vector<kg_compiler::WindowWorld> FindWorlds(
    const kg_compiler::Compilation& compilation,
    const kg_compiler::SeamRules& rules);

// Plans the mission of `compilation`, agents in parallel on all cores. Parts
// unchanged since `previous` (may be null) are reused: graphs, arrival fields,
// flights, walks. The plan is the same without reuse.
PlannedMission PlanMission(const kg_compiler::Compilation& compilation,
                           const PlannedMission* previous);

}  // namespace kg_selector

#endif  // KG_SELECTOR_TEAM_PLAN_MISSION_H_
