#include "kg_selector/team/plan_mission.h"

#include <stdexcept>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "kg_base/common/input_error.h"
#include "kg_base/common/parallel.h"
#include "kg_base/common/stopwatch.h"

namespace kg_selector {
namespace {

using kg_compiler::Compilation;
using kg_compiler::NavGraphs;
using kg_compiler::SeamRules;
using kg_compiler::WindowWorld;

struct AgentGraphs {
  NavGraphs graphs;
  std::string trouble;  // Reason if there are none.
  GraphCache cache;
};

// Rasters of a compilation, by hash.
class RasterIndex {
 public:
  explicit RasterIndex(const Compilation& compilation) {
    for (const auto& tensor : compilation.tensors) {
      tensors_.emplace(tensor->hash, tensor.get());
    }
    for (const auto& field : compilation.fields) {
      fields_.emplace(field->hash, &field->field);
    }
  }

  // Rasters in the order of the rules' windows.
  std::vector<WindowWorld> FindWorlds(const SeamRules& rules) const {
    std::vector<WindowWorld> worlds;
    for (const kg_compiler::WindowRules& window : rules.windows) {
      worlds.push_back({Find(tensors_, window.tensor_hash),
                        Find(fields_, window.field_hash)});
    }
    return worlds;
  }

 private:
  template <typename T>
  using ByHash = std::unordered_map<std::string_view, const T*>;

  template <typename T>
  static const T* Find(const ByHash<T>& rasters, const std::string& hash) {
    const auto found = rasters.find(hash);
    if (found != rasters.end()) return found->second;
    throw std::logic_error("the compilation has no raster " + hash);
  }

  ByHash<kg_compiler::MissionTensor> tensors_;
  ByHash<kg_base::VectorField> fields_;
};

AgentGraphs CompileGraphs(const SeamRules& rules,
                          const std::vector<WindowWorld>& worlds,
                          const PlannedMission* previous) {
  AgentGraphs made;
  if (previous) {
    const auto last = previous->caches.find(rules.agent_id);
    if (last != previous->caches.end()) made.cache = last->second;
  }
  try {
    made.graphs = CompileWalkedGraphs(rules, worlds, &made.cache);
  } catch (const kg_base::InputError& error) {
    made.trouble = error.what();
  }
  return made;
}

std::vector<AgentGraphs> CompileAll(const Compilation& compilation,
                                    const PlannedMission* previous) {
  const RasterIndex rasters(compilation);
  std::vector<AgentGraphs> made(compilation.rules.size());
  kg_base::ForEachInParallel(made.size(), [&](std::size_t i) {
    const SeamRules& rules = compilation.rules[i];
    made[i] = CompileGraphs(rules, rasters.FindWorlds(rules), previous);
  });
  return made;
}

// If a planner found no path, its own reason precedes that of the selector.
void AddReasons(const std::map<std::string, std::string>& unplannable,
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

TeamRules ToTeamRules(const Compilation& compilation) {
  const kg_mission::CoordinationFacts& facts = compilation.coordination.facts;
  TeamRules team;
  team.event_capacity = compilation.coordination.event_capacity;
  team.event_windows = compilation.coordination.event_windows;
  team.separation_m = facts.separation_m;
  team.separation_is_hard = facts.separation_is_hard;
  team.separation_weight_per_m = facts.separation_weight;
  team.mode = facts.mode;
  team.max_rounds = facts.max_rounds;
  team.gap_goal = facts.gap_goal;
  team.auction_epsilon = facts.auction_epsilon;
  team.time_limit_s = facts.select_limit_s;
  team.fairness = facts.fairness;
  team.fairness_weight = facts.fairness_weight;
  for (const SeamRules& rules : compilation.rules) {
    team.energy_budget_j[rules.agent_id] = rules.energy_budget_j;
  }
  for (const kg_mission::TimeWindow& window : compilation.mission.windows) {
    // Earlier windows have ended.
    if (window.index >= compilation.first_window) {
      team.window_end_s[window.index] = window.end_s;
    }
  }
  return team;
}

std::vector<WindowWorld> FindWorlds(const Compilation& compilation,
                                    const SeamRules& rules) {
  return RasterIndex(compilation).FindWorlds(rules);
}

PlannedMission PlanMission(const Compilation& compilation,
                           const PlannedMission* previous) {
  PlannedMission planned;
  kg_base::Stopwatch watch;
  // Waypoints and seams of all agents, in parallel.
  std::vector<AgentGraphs> graphs = CompileAll(compilation, previous);
  planned.stage_seconds["graphs"] = watch.Elapsed_s();
  planned.rules = ToTeamRules(compilation);
  for (const SeamRules& rules : compilation.rules) {
    AgentGraphs& made = graphs[planned.members.size()];
    if (!made.trouble.empty()) {
      planned.unplannable[rules.agent_id] = made.trouble;
    }
    planned.members.push_back({rules, std::move(made.graphs)});
    planned.caches[rules.agent_id] = std::move(made.cache);
  }
  watch.Lap_s();  // The loop above belongs to neither stage.
  planned.plan = PlanTeam(planned.rules, planned.members);
  planned.stage_seconds["team"] = watch.Elapsed_s();
  AddReasons(planned.unplannable, &planned.plan);
  return planned;
}

}  // namespace kg_selector
