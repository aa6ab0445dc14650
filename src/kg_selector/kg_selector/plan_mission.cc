#include "kg_selector/plan_mission.h"

#include <stdexcept>
#include <utility>

#include "kg_core/base/input_error.h"
#include "kg_core/base/parallel.h"

namespace kg_selector {
namespace {

using kg_compiler::Compilation;
using kg_compiler::NavGraph;
using kg_compiler::SeamRules;
using kg_compiler::WindowWorld;

struct Graphs {
  std::vector<NavGraph> graphs;
  std::string trouble;  // Why there are none.
};

Graphs CompileGraphs(const SeamRules& rules,
                     const std::vector<WindowWorld>& worlds,
                     const TeamMember* previous) {
  static const std::vector<NavGraph> kNone;
  try {
    return {kg_compiler::CompileNavGraphs(rules, worlds,
                                          previous ? previous->graphs : kNone),
            ""};
  } catch (const kg_core::InputError& error) {
    return {{}, error.what()};
  }
}

std::vector<Graphs> CompileAll(const Compilation& compilation,
                               const PlannedMission* previous) {
  std::vector<Graphs> made(compilation.rules.size());
  kg_core::ForEachInParallel(made.size(), [&](std::size_t i) {
    const SeamRules& rules = compilation.rules[i];
    made[i] = CompileGraphs(
        rules, WorldsOf(compilation, rules),
        previous ? previous->FindMember(rules.agent_id) : nullptr);
  });
  return made;
}

template <typename T>
const T& Named(const std::vector<T>& members, const std::string& hash) {
  for (const T& member : members) {
    if (member->hash == hash) return member;
  }
  throw std::logic_error("the compilation has no raster " + hash);
}

// A planner that finds no path says so in its own words, which go before the
// selector's.
void TellWhy(const std::map<std::string, std::string>& unplannable,
             TeamPlan* plan) {
  for (auto& [agent, why] : plan->unassigned) {
    const auto note = plan->notes.find(agent);
    if (note != plan->notes.end()) why = note->second;
    const auto trouble = unplannable.find(agent);
    if (trouble != unplannable.end()) why = trouble->second;
  }
}

}  // namespace

const TeamMember* PlannedMission::FindMember(const std::string& agent) const {
  for (const TeamMember& member : members) {
    if (NameOf(member) == agent) return &member;
  }
  return nullptr;
}

const Pathlet* PlannedMission::FindPath(const std::string& agent) const {
  for (const Pathlet& pathlet : plan.committed) {
    if (pathlet.agent == agent) return &pathlet;
  }
  return nullptr;
}

TeamRules ToTeamRules(const kg_compiler::CoordinationRules& rules) {
  TeamRules team;
  team.event_capacity = rules.event_capacity;
  team.separation_m = rules.facts.separation_m;
  team.separation_is_hard = rules.facts.separation_is_hard;
  team.separation_weight_per_m = rules.facts.separation_weight;
  team.mode = rules.facts.mode;
  team.max_rounds = rules.facts.max_rounds;
  return team;
}

std::vector<WindowWorld> WorldsOf(const Compilation& compilation,
                                  const SeamRules& rules) {
  std::vector<WindowWorld> worlds;
  for (const kg_compiler::WindowRules& window : rules.windows) {
    worlds.push_back({Named(compilation.tensors, window.tensor_hash).get(),
                      &Named(compilation.fields, window.field_hash)->field});
  }
  return worlds;
}

PlannedMission PlanMission(const Compilation& compilation,
                           const PlannedMission* previous) {
  std::vector<Graphs> graphs = CompileAll(compilation, previous);
  PlannedMission planned;
  planned.rules = ToTeamRules(compilation.coordination);
  for (const SeamRules& rules : compilation.rules) {
    Graphs& made = graphs[planned.members.size()];
    if (!made.trouble.empty())
      planned.unplannable[rules.agent_id] = made.trouble;
    planned.members.push_back({rules, std::move(made.graphs)});
    for (const kg_compiler::WindowRules& window : rules.windows) {
      planned.rules.window_end_s.emplace(window.window, window.end_s);
    }
  }
  planned.plan = PlanTeam(planned.rules, planned.members);
  TellWhy(planned.unplannable, &planned.plan);
  return planned;
}

}  // namespace kg_selector
