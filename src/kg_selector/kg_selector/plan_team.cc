#include "kg_selector/plan_team.h"

#include <set>

#include "kg_selector/masking.h"
#include "kg_selector/path_rules.h"

namespace kg_selector {

const std::string& NameOf(const TeamMember& member) {
  return member.rules.agent_id.empty() ? member.rules.agent_iri
                                       : member.rules.agent_id;
}

const char* NoPathNote(const bool alone) {
  return alone ? "no path leads through all windows"
               : "no path is left beside the others'";
}

Candidates PlanUnder(const TeamRules& rules, const TeamMember& member,
                     const Ask& ask) {
  if (member.graphs.empty()) return {};
  const kg_compiler::SeamRules open =
      CloseEvents(member.rules, ask.full_events);
  const kg_planner::KBest best =
      ChoosePaths(open, ToTrellis(open, member.graphs),
                  MaskCommitted(rules, member.graphs, ask.around));
  Candidates candidates;
  candidates.proven = best.proven;
  candidates.bound = best.bound;
  for (const kg_planner::Path& path : best.paths) {
    candidates.pathlets.push_back(
        ToPathlet(open, member.graphs, path,
                  static_cast<int>(candidates.pathlets.size())));
    candidates.pathlets.back().agent = NameOf(member);
  }
  if (best.paths.empty()) candidates.note = BudgetNote(open, best);
  if (best.paths.empty() && candidates.note.empty())
    candidates.note = NoPathNote(ask.around.empty());
  return candidates;
}

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
    for (const auto& window : member.rules.windows)
      rules.window_end_s.emplace(window.window, window.end_s);
  }
  TeamPlan plan;
  const std::unique_ptr<Coordinator> team = MakeCoordinator(rules, agents);
  while (!team->Advance()) {
    const std::set<std::string> waiting = team->waiting_for();
    for (const std::string& agent : waiting) {
      Candidates found = PlanUnder(rules, *by_agent[agent], team->AskOf(agent));
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
