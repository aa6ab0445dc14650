#include "kg_selector/explain/planned_world.h"

#include <stdexcept>
#include <utility>

#include "kg_base/common/input_error.h"
#include "kg_base/common/join_strings.h"
#include "kg_core/rdf/namespaces.h"

namespace kg_selector {

using kg_base::InputError;

void NameAgentsByIri(PlannedWorld* world) {
  const auto rename = [&](std::string* agent) {
    for (const kg_mission::Agent& known : world->compilation->mission.agents) {
      if (*agent == known.id) *agent = known.iri;
    }
  };
  for (TeamMember& member : world->members) rename(&member.rules.agent_iri);
  for (Pathlet& pathlet : world->plan.committed) rename(&pathlet.agent);
  for (RejectedPath& rejection : world->plan.rejections) {
    rename(&rejection.pathlet.agent);
    rename(&rejection.conflict.with_agent);
  }
  // Map keys are immutable: build a new map.
  std::map<std::string, std::string> unassigned;
  for (const auto& [agent, why] : world->plan.unassigned) {
    std::string name = agent;
    rename(&name);
    unassigned[name] = why;
  }
  world->plan.unassigned = std::move(unassigned);
  std::map<std::string, double> budgets_j;
  for (const auto& [agent, budget_j] : world->rules.energy_budget_j) {
    std::string name = agent;
    rename(&name);
    budgets_j[name] = budget_j;
  }
  world->rules.energy_budget_j = std::move(budgets_j);
}

const kg_mission::Agent& FindAgent(const PlannedWorld& world,
                                   const std::string& name) {
  std::vector<std::string> known;
  for (const kg_mission::Agent& agent : world.compilation->mission.agents) {
    if (name == agent.id || name == agent.iri ||
        name == kg_core::AbbreviateIri(agent.iri)) {
      return agent;
    }
    known.push_back(agent.id);
  }
  throw InputError("agent '" + name + "' is not known; there are " +
                   kg_base::JoinStrings(known));
}

const TeamMember& FindMember(const PlannedWorld& world,
                             const kg_mission::Agent& agent) {
  for (const TeamMember& member : world.members) {
    if (member.rules.agent_iri != agent.iri) continue;
    if (member.graphs.size() == member.rules.windows.size()) return member;
    throw InputError("only " + std::to_string(member.graphs.size()) + " of " +
                     std::to_string(member.rules.windows.size()) +
                     " waypoint graphs of " + agent.id + " have been received");
  }
  throw InputError("no waypoint graphs of " + agent.id + " have been received");
}

std::size_t FindStage(const TeamMember& member, int window) {
  for (std::size_t s = 0; s < member.graphs.size(); ++s) {
    if (member.graphs[s].window == window) return s;
  }
  const std::string who =
      "window " + std::to_string(window) + " of " + member.rules.agent_id;
  if (member.graphs.empty()) {
    throw InputError(who + ": no waypoint graphs have been received");
  }
  throw InputError(who + " is not planned: the windows are " +
                   std::to_string(member.graphs.front().window) + " to " +
                   std::to_string(member.graphs.back().window));
}

const Pathlet* FindPath(const PlannedWorld& world,
                        const std::string& agent_iri) {
  for (const Pathlet& pathlet : world.plan.committed) {
    if (pathlet.agent == agent_iri) return &pathlet;
  }
  return nullptr;
}

const Pathlet& NeedPath(const PlannedWorld& world,
                        const kg_mission::Agent& agent) {
  const Pathlet* path = FindPath(world, agent.iri);
  if (path != nullptr) return *path;
  const auto why = world.plan.unassigned.find(agent.iri);
  const bool has_reason = why != world.plan.unassigned.end();
  throw InputError(agent.id + " has no path" +
                   (has_reason ? ": " + why->second : std::string()));
}

std::vector<Pathlet> CommittedBefore(const PlannedWorld& world,
                                     const std::string& agent_iri) {
  std::vector<Pathlet> before;
  for (const Pathlet& pathlet : world.plan.committed) {
    if (pathlet.agent == agent_iri) break;
    before.push_back(pathlet);
  }
  return before;
}

const kg_compiler::TraverseEdge& EdgeTaken(const TeamMember& member,
                                           const Pathlet& pathlet,
                                           std::size_t stage) {
  const int from = stage == 0 ? 0 : pathlet.visits[stage - 1].waypoint;
  const Visit& visit = pathlet.visits[stage];
  const auto* edge = kg_compiler::FindEdge(member.graphs[stage], from,
                                           visit.waypoint, WaypointsVia(visit));
  if (edge) return *edge;
  throw std::logic_error("a path takes an edge that its graph does not have");
}

}  // namespace kg_selector
