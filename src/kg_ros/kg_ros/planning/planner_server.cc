#include "kg_ros/planning/planner_server.h"

#include <algorithm>
#include <cmath>

#include "kg_core/base/input_error.h"
#include "kg_core/base/stopwatch.h"
#include "kg_planner/k_best/staging.h"
#include "kg_ros/conversion/message_units.h"
#include "kg_ros/conversion/plan_conversion.h"
#include "kg_ros/conversion/rules_conversion.h"
#include "kg_ros/conversion/tensor_conversion.h"
#include "kg_ros/knowledge/pending_reports.h"
#include "kg_selector/paths/masking.h"
#include "kg_selector/team/plan_team.h"
#include "ros/time.h"

namespace kg_ros {
namespace {

using kg_compiler::NavGraph;
using kg_compiler::NavGraphs;
using kg_core::InputError;

std::size_t CountEdges(const NavGraphs& graphs) {
  std::size_t count = 0;
  for (const NavGraph& graph : graphs) count += graph.edges.size();
  return count;
}

// The edges that a pathlet flies, by window, of the graphs it was made of. Ends
// where there is none.
std::vector<int> EdgesOf(const kg_msgs::Pathlet& pathlet,
                         const NavGraphs& graphs) {
  std::vector<int> edges;
  int from = 0;
  for (std::size_t i = 0; i < pathlet.visits.size() && i < graphs.size(); ++i) {
    const kg_msgs::Visit& visit = pathlet.visits[i];
    std::vector<int> via;
    for (const kg_msgs::Stop& stop : visit.via) {
      via.push_back(static_cast<int>(stop.waypoint));
    }
    const int to = static_cast<int>(visit.waypoint);
    const kg_compiler::TraverseEdge* edge =
        kg_compiler::FindEdge(graphs[i], from, to, via);
    if (edge == nullptr) break;
    edges.push_back(static_cast<int>(edge - graphs[i].edges.data()));
    from = to;
  }
  return edges;
}

}  // namespace

void PlannerServer::Take(const kg_msgs::SeamRules& message) {
  if (message.cycle < cycle_) return;  // Late: a newer cycle has begun.
  rules_ = FromMessage(message);
  cycle_ = message.cycle;
  due_ = true;
}

void PlannerServer::Take(const kg_msgs::MissionTensor& message) {
  const auto known = tensors_.find(message.window);
  if (known != tensors_.end() && known->second->hash == message.hash) return;
  tensors_[message.window] =
      std::make_shared<const kg_compiler::MissionTensor>(FromMessage(message));
}

void PlannerServer::Take(const kg_msgs::WorkField& message) {
  const auto known = fields_.find(message.window);
  if (known != fields_.end() && known->second->hash == message.hash) return;
  fields_[message.window] =
      std::make_shared<const kg_compiler::WorkField>(FromMessage(message));
}

std::string PlannerServer::Missing() const {
  for (const kg_compiler::WindowRules& window : rules_.windows) {
    const std::string name = " of window " + std::to_string(window.window);
    const auto tensor = tensors_.find(window.window);
    if (tensor == tensors_.end() ||
        tensor->second->hash != window.tensor_hash) {
      return "the tensor" + name;
    }
    const auto field = fields_.find(window.window);
    if (field == fields_.end() || field->second->hash != window.field_hash) {
      return "the work field" + name;
    }
  }
  return "";
}

bool PlannerServer::IsComplete() const { return Missing().empty(); }

std::vector<kg_compiler::WindowWorld> PlannerServer::Worlds() const {
  std::vector<kg_compiler::WindowWorld> worlds;
  for (const kg_compiler::WindowRules& window : rules_.windows) {
    worlds.push_back(
        {tensors_.at(window.window).get(), &fields_.at(window.window)->field});
  }
  return worlds;
}

kg_msgs::Candidates PlannerServer::Header(const std::uint32_t round) const {
  kg_msgs::Candidates candidates;
  candidates.header.stamp = ros::Time::now();
  candidates.world_version = rules_.world_version;
  candidates.cycle = cycle_;
  candidates.agent = rules_.agent_id;
  candidates.agent_iri = rules_.agent_iri;
  candidates.round = round;
  return candidates;
}

kg_msgs::Candidates PlannerServer::Stitch(const AskedOf& asked,
                                          const std::uint32_t round) const {
  kg_selector::TeamRules team;
  team.separation_m = asked.separation_m;
  for (const kg_compiler::WindowRules& window : rules_.windows) {
    team.window_end_s[window.window] = window.end_s;
  }
  const kg_core::Stopwatch watch;
  const kg_selector::Candidates found =
      kg_selector::PlanUnder(team, {rules_, graphs_, memory_}, asked.ask);
  kg_msgs::Candidates candidates = Header(round);
  candidates.proven = found.proven;
  candidates.bound = FiniteOrUnknown(found.bound);
  candidates.note = found.note;
  for (const kg_selector::Pathlet& pathlet : found.pathlets) {
    candidates.pathlets.push_back(ToMessage(pathlet, graphs_));
  }
  candidates.stages = {
      Stage("stitch", watch.Elapsed_s(), candidates.pathlets.size())};
  return candidates;
}

// Edges of the best path that the planner takes for what comes later (A45).
void PlannerServer::MarkStaging(const kg_msgs::Candidates& candidates,
                                std::vector<kg_msgs::NavGraph>* graphs) const {
  if (candidates.pathlets.empty()) return;
  kg_planner::Path path;
  path.seams = EdgesOf(candidates.pathlets.front(), graphs_);
  if (path.seams.size() != graphs_.size()) return;
  const std::vector<bool> staging = kg_planner::FindStaging(
      kg_selector::ToTrellis(rules_, graphs_), {}, path);
  // The messages' edges are the graphs', in their order.
  for (std::size_t i = 0; i < staging.size(); ++i) {
    (*graphs)[i].edges[path.seams[i]].staging = staging[i];
  }
}

PlannerAnswer PlannerServer::Plan() {
  due_ = false;
  PlannerAnswer answer;
  const kg_core::Stopwatch watch;
  try {
    graphs_ = kg_selector::CompileWalkedGraphs(rules_, Worlds(), &cache_);
  } catch (const InputError& error) {
    graphs_.clear();
    trouble_ = error.what();
    answer.candidates = Stitch({}, 0);
    answer.candidates.note = trouble_;
    return answer;
  }
  const double graphs_s = watch.Elapsed_s();
  answer.candidates = Stitch({}, 0);
  answer.candidates.stages.insert(
      answer.candidates.stages.begin(),
      Stage("nav_graphs", graphs_s, CountEdges(graphs_)));
  for (const NavGraph& graph : graphs_) {
    answer.nav_graphs.push_back(ToMessage(graph, rules_));
    answer.nav_graphs.back().cycle = cycle_;
    answer.nav_graphs.back().header.stamp = answer.candidates.header.stamp;
  }
  MarkStaging(answer.candidates, &answer.nav_graphs);
  return answer;
}

std::optional<PlannerAnswer> PlannerServer::PlanAgain(
    const kg_msgs::Rejections& message) {
  if (message.cycle != cycle_ || message.round == 0 || due_) {
    return std::nullopt;
  }
  const std::optional<AskedOf> asked = AskOf(message, rules_.agent_id);
  if (!asked) return std::nullopt;
  PlannerAnswer answer;
  answer.candidates = Stitch(*asked, message.round);
  if (graphs_.empty()) answer.candidates.note = trouble_;
  return answer;
}

}  // namespace kg_ros
