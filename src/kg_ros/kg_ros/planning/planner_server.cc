#include "kg_ros/planning/planner_server.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <set>

#include "kg_core/base/input_error.h"
#include "kg_planner/k_best.h"
#include "kg_ros/conversion/plan_conversion.h"
#include "kg_ros/conversion/rules_conversion.h"
#include "kg_ros/conversion/tensor_conversion.h"
#include "kg_ros/knowledge/pending_reports.h"
#include "kg_selector/masking.h"
#include "kg_selector/plan_team.h"
#include "ros/time.h"

namespace kg_ros {
namespace {

using kg_compiler::NavGraph;
using kg_compiler::NavGraphs;
using kg_core::InputError;

double Seconds(std::chrono::steady_clock::time_point since) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - since)
      .count();
}

std::size_t CountEdges(const NavGraphs& graphs) {
  std::size_t count = 0;
  for (const NavGraph& graph : graphs) count += graph.edges.size();
  return count;
}

// What a step brings at once: the rewards on its way less its price.
double Immediate(const NavGraph& graph, const kg_compiler::TraverseEdge& edge) {
  double reward = 0.0;
  for (const int stop : kg_compiler::StopsOf(edge)) {
    const kg_compiler::Waypoint& waypoint = graph.waypoints[stop];
    reward += waypoint.score + waypoint.event_reward;
  }
  return reward - edge.seam_cost;
}

// Staging: the plan takes this edge though another from the same place would
// bring more at once (A45).
bool IsStaging(const NavGraph& graph, const kg_compiler::TraverseEdge& taken) {
  const double now = Immediate(graph, taken);
  return std::any_of(graph.edges.begin(), graph.edges.end(),
                     [&](const kg_compiler::TraverseEdge& edge) {
                       return edge.from == taken.from &&
                              Immediate(graph, edge) > now;
                     });
}

std::vector<std::uint32_t> ViaOf(const kg_msgs::Visit& visit) {
  std::vector<std::uint32_t> via;
  for (const kg_msgs::Stop& stop : visit.via) via.push_back(stop.waypoint);
  return via;
}

kg_selector::Pathlet Committed(const kg_msgs::Cooling& cooling) {
  kg_selector::Pathlet pathlet;
  pathlet.agent = cooling.by_agent;
  pathlet.track = FromMessage(cooling.track);
  return pathlet;
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

kg_msgs::Candidates PlannerServer::Stitch(
    const std::vector<const kg_msgs::Cooling*>& cooling) {
  kg_selector::TeamRules team;
  for (const kg_compiler::WindowRules& window : rules_.windows) {
    team.window_end_s[window.window] = window.end_s;
  }
  std::vector<kg_selector::Pathlet> committed;
  std::set<std::string> full_events;
  for (const kg_msgs::Cooling* one : cooling) {
    team.separation_m = one->separation_m;
    committed.push_back(Committed(*one));
    full_events.insert(one->full_events.begin(), one->full_events.end());
  }
  const kg_compiler::SeamRules open =
      kg_selector::CloseEvents(rules_, full_events);
  kg_planner::KBestOptions options;
  options.paths = rules_.candidates;
  const kg_planner::KBest best = kg_planner::FindKBest(
      kg_selector::ToTrellis(open, graphs_),
      kg_selector::MaskCommitted(team, graphs_, committed), options);
  kg_msgs::Candidates candidates;
  candidates.proven = best.proven;
  candidates.bound = best.bound;
  for (std::size_t i = 0; i < best.paths.size(); ++i) {
    candidates.pathlets.push_back(
        ToMessage(kg_selector::ToPathlet(open, graphs_, best.paths[i],
                                         static_cast<int>(i)),
                  graphs_));
  }
  if (best.paths.empty()) {
    candidates.note = kg_selector::NoPathNote(cooling.empty());
  }
  return candidates;
}

void PlannerServer::MarkStaging(const kg_msgs::Candidates& candidates,
                                std::vector<kg_msgs::NavGraph>* graphs) const {
  if (candidates.pathlets.empty()) return;
  std::uint32_t from = 0;
  const auto& visits = candidates.pathlets.front().visits;
  for (std::size_t i = 0; i < visits.size() && i < graphs->size(); ++i) {
    // The message's edges are the graph's, in their order.
    for (std::size_t e = 0; e < graphs_[i].edges.size(); ++e) {
      kg_msgs::TraverseEdge& edge = (*graphs)[i].edges[e];
      if (edge.from == from && edge.to == visits[i].waypoint &&
          edge.via == ViaOf(visits[i])) {
        edge.staging = IsStaging(graphs_[i], graphs_[i].edges[e]);
      }
    }
    from = visits[i].waypoint;
  }
}

PlannerAnswer PlannerServer::Plan() {
  due_ = false;
  PlannerAnswer answer;
  const auto begin = std::chrono::steady_clock::now();
  try {
    graphs_ = kg_selector::CompileWalkedGraphs(rules_, Worlds(), &cache_);
  } catch (const InputError& error) {
    graphs_.clear();
    answer.candidates = Header(0);
    answer.candidates.note = error.what();
    return answer;
  }
  const double graphs_s = Seconds(begin);
  const kg_msgs::Candidates stitched = Stitch({});
  answer.candidates = Header(0);
  answer.candidates.pathlets = stitched.pathlets;
  answer.candidates.note = stitched.note;
  answer.candidates.proven = stitched.proven;
  answer.candidates.bound = stitched.bound;
  answer.candidates.stages = {
      Stage("nav_graphs", graphs_s, CountEdges(graphs_)),
      Stage("stitch", Seconds(begin) - graphs_s, stitched.pathlets.size())};
  for (const NavGraph& graph : graphs_) {
    answer.nav_graphs.push_back(ToMessage(graph, rules_));
    answer.nav_graphs.back().cycle = cycle_;
    answer.nav_graphs.back().header.stamp = answer.candidates.header.stamp;
  }
  MarkStaging(answer.candidates, &answer.nav_graphs);
  return answer;
}

std::vector<PlannerAnswer> PlannerServer::PlanAround(
    const kg_msgs::Rejections& message) {
  if (message.cycle != cycle_ || message.round == 0 || graphs_.empty()) {
    return {};
  }
  std::vector<const kg_msgs::Cooling*> cooling;
  for (const kg_msgs::Cooling& one : message.cooling) {
    if (one.agent == rules_.agent_id) cooling.push_back(&one);
  }
  if (cooling.empty()) return {};
  const auto begin = std::chrono::steady_clock::now();
  const kg_msgs::Candidates stitched = Stitch(cooling);
  PlannerAnswer answer;
  answer.candidates = Header(message.round);
  answer.candidates.pathlets = stitched.pathlets;
  answer.candidates.note = stitched.note;
  answer.candidates.proven = stitched.proven;
  answer.candidates.bound = stitched.bound;
  answer.candidates.stages = {
      Stage("stitch", Seconds(begin), stitched.pathlets.size())};
  return {answer};
}

}  // namespace kg_ros
