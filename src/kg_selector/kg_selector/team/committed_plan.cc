#include "kg_selector/team/committed_plan.h"

namespace kg_selector {

std::vector<std::string> UnassignedLines(const CommittedPlan& plan) {
  std::vector<std::string> lines;
  for (const auto& [agent, why] : plan.unassigned) {
    lines.push_back(agent + ": " + why);
  }
  return lines;
}

CommittedPlan ToCommittedPlan(const PlannedMission& planned) {
  CommittedPlan plan;
  plan.rounds = planned.plan.rounds - 1;  // Replanning rounds only.
  plan.mode = planned.rules.mode;
  plan.bound = planned.plan.bound;
  for (const Pathlet& pathlet : planned.plan.committed) {
    const TeamMember* member = planned.FindMember(pathlet.agent);
    plan.assignments.push_back({member->rules.agent_iri, pathlet});
    plan.reward += pathlet.reward;
    plan.seam_cost += pathlet.seam_cost;
  }
  plan.unassigned = planned.plan.unassigned;
  return plan;
}

}  // namespace kg_selector
