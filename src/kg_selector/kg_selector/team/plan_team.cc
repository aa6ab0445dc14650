#include "kg_selector/team/plan_team.h"

#include <memory>
#include <set>

#include "kg_selector/team/coordinator.h"
#include "kg_selector/team/team_modes.h"

namespace kg_selector {

double TeamPlan::score() const {
  double sum = 0.0;
  for (const Pathlet& pathlet : committed) sum += pathlet.score();
  return sum;
}

TeamPlan PlanTeam(TeamRules rules, const std::vector<TeamMember>& members) {
  std::map<std::string, const TeamMember*> by_agent;
  std::vector<std::string> agents;
  for (const TeamMember& member : members) {
    by_agent[NameOf(member)] = &member;
    agents.push_back(NameOf(member));
    for (const auto& window : member.rules.windows) {
      rules.window_end_s.emplace(window.window, window.end_s);
    }
  }
  TeamPlan plan;
  const std::unique_ptr<Coordinator> team = MakeCoordinator(rules, agents);
  while (!team->Advance()) {
    // A copy: Offer() changes the set.
    const std::set<std::string> waiting = team->waiting_for();
    for (const std::string& agent : waiting) {
      AgentOffer found =
          PlanPriced(rules, *by_agent[agent], team->RequestFor(agent));
      plan.proven = plan.proven && found.proven;
      plan.notes.erase(agent);
      if (!found.note.empty()) plan.notes[agent] = found.note;
      team->Offer(agent, std::move(found));
    }
  }
  static_cast<TeamOutcome&>(plan) = team->outcome();
  return plan;
}

}  // namespace kg_selector
