#include "kg_engine/planning/agent_planner.h"

#include <limits>
#include <utility>

#include "kg_base/common/clock.h"
#include "kg_base/common/input_error.h"
#include "kg_base/common/stopwatch.h"
#include "kg_planner/k_best/staging.h"
#include "kg_selector/paths/masking.h"
#include "kg_selector/team/plan_team.h"

namespace kg_engine {
namespace {

using kg_base::InputError;
using kg_compiler::NavGraph;
using kg_compiler::NavGraphs;
using kg_selector::AgentCandidates;

std::size_t CountEdges(const NavGraphs& graphs) {
  std::size_t count = 0;
  for (const NavGraph& graph : graphs) count += graph.edges.size();
  return count;
}

// By window: the planned path's edges chosen for a later gain (A45); empty if
// the path does not cover all windows.
std::vector<bool> FindStagingEdges(const kg_compiler::SeamRules& rules,
                                   const NavGraphs& graphs,
                                   const kg_selector::Pathlet& pathlet) {
  kg_planner::Path path;
  for (const kg_selector::Visit& visit : pathlet.visits) {
    path.seams.push_back(visit.edge);
  }
  if (path.seams.size() != graphs.size()) return {};
  return kg_planner::FindStaging(kg_selector::ToTrellis(rules, graphs), {},
                                 path);
}

}  // namespace

void AgentPlanner::Take(const kg_compiler::SeamRules& rules,
                        const std::uint64_t cycle) {
  if (cycle < cycle_) return;  // Outdated: a newer cycle has begun.
  rules_ = rules;
  cycle_ = cycle;
  due_ = true;
}

void AgentPlanner::Take(TensorPointer tensor) {
  if (HasTensor(tensor->window, tensor->hash)) return;
  const int window = tensor->window;
  tensors_[window] = std::move(tensor);
}

void AgentPlanner::Take(FieldPointer field) {
  if (HasField(field->window, field->hash)) return;
  const int window = field->window;
  fields_[window] = std::move(field);
}

bool AgentPlanner::HasTensor(const int window, const std::string& hash) const {
  const auto known = tensors_.find(window);
  return known != tensors_.end() && known->second->hash == hash;
}

bool AgentPlanner::HasField(const int window, const std::string& hash) const {
  const auto known = fields_.find(window);
  return known != fields_.end() && known->second->hash == hash;
}

std::string AgentPlanner::Missing() const {
  for (const kg_compiler::WindowRules& window : rules_.windows) {
    const std::string name = " of window " + std::to_string(window.window);
    if (!HasTensor(window.window, window.tensor_hash)) {
      return "the tensor" + name;
    }
    if (!HasField(window.window, window.field_hash)) {
      return "the work field" + name;
    }
  }
  return "";
}

bool AgentPlanner::IsComplete() const { return Missing().empty(); }

std::vector<kg_compiler::WindowWorld> AgentPlanner::Worlds() const {
  std::vector<kg_compiler::WindowWorld> worlds;
  for (const kg_compiler::WindowRules& window : rules_.windows) {
    worlds.push_back(
        {tensors_.at(window.window).get(), &fields_.at(window.window)->field});
  }
  return worlds;
}

AgentCandidates AgentPlanner::Header(const std::uint32_t round) const {
  AgentCandidates candidates;
  candidates.time_s = kg_base::Now_s();
  candidates.world_version = rules_.world_version;
  candidates.cycle = cycle_;
  candidates.agent = rules_.agent_id;
  candidates.agent_iri = rules_.agent_iri;
  candidates.round = round;
  return candidates;
}

AgentCandidates AgentPlanner::Stitch(const kg_selector::AskedOf& asked,
                                     const std::uint32_t round) const {
  kg_selector::TeamRules team;
  team.separation_m = asked.separation_m;
  for (const kg_compiler::WindowRules& window : rules_.windows) {
    team.window_end_s[window.window] = window.end_s;
  }
  const kg_base::Stopwatch watch;
  AgentCandidates candidates = Header(round);
  candidates.found =
      kg_selector::PlanPriced(team, {rules_, graphs_, memory_}, asked.ask);
  if (candidates.found.pathlets.empty() && candidates.found.proven) {
    // Proven that there is no path: the agent adds nothing to any plan.
    candidates.found.bound = -std::numeric_limits<double>::infinity();
  }
  candidates.stages = {
      {"stitch", watch.Elapsed_s(), candidates.found.pathlets.size()}};
  return candidates;
}

std::vector<AgentGraph> AgentPlanner::Graphs(
    const AgentCandidates& candidates) const {
  std::vector<bool> staging;
  const auto& pathlets = candidates.found.pathlets;
  if (!pathlets.empty()) {
    staging = FindStagingEdges(rules_, graphs_, pathlets.front());
  }
  std::vector<AgentGraph> graphs;
  for (std::size_t i = 0; i < graphs_.size(); ++i) {
    AgentGraph graph{candidates.time_s, candidates.world_version, cycle_,
                     rules_.agent_id,   graphs_.Share(i),         {}};
    if (!staging.empty()) {
      graph.staging.assign(graph.graph->edges.size(), false);
      graph.staging.at(pathlets.front().visits[i].edge) = staging[i];
    }
    graphs.push_back(std::move(graph));
  }
  return graphs;
}

PlannerAnswer AgentPlanner::Plan() {
  due_ = false;
  PlannerAnswer answer;
  const kg_base::Stopwatch watch;
  try {
    graphs_ = kg_selector::CompileWalkedGraphs(rules_, Worlds(), &cache_);
  } catch (const InputError& error) {
    // Answer anyway, so that the selector does not wait for this agent.
    graphs_.clear();
    trouble_ = error.what();
    answer.candidates = Stitch({}, 0);
    answer.candidates.found.note = trouble_;
    return answer;
  }
  const double graphs_s = watch.Elapsed_s();
  answer.candidates = Stitch({}, 0);
  answer.candidates.stages.insert(
      answer.candidates.stages.begin(),
      {"nav_graphs", graphs_s, CountEdges(graphs_)});
  answer.graphs = Graphs(answer.candidates);
  return answer;
}

std::optional<PlannerAnswer> AgentPlanner::PlanAgain(
    const kg_selector::RoundRequest& request) {
  if (request.cycle != cycle_ || request.round == 0 || due_) {
    return std::nullopt;
  }
  if (last_end_ && kg_selector::HasEnded(request, *last_end_)) {
    return std::nullopt;
  }
  const std::optional<kg_selector::AskedOf> asked =
      kg_selector::AskOf(request, rules_.agent_id);
  if (!asked) return std::nullopt;
  PlannerAnswer answer;
  answer.candidates = Stitch(*asked, request.round);
  if (graphs_.empty()) answer.candidates.found.note = trouble_;
  return answer;
}

}  // namespace kg_engine
