#include "kg_ros/selection/selector_server.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "kg_core/base/input_error.h"
#include "kg_ros/conversion/ask_conversion.h"
#include "kg_ros/conversion/message_units.h"
#include "kg_ros/conversion/plan_conversion.h"
#include "kg_ros/conversion/rules_conversion.h"
#include "kg_ros/knowledge/pending_reports.h"
#include "kg_selector/team/stability.h"
#include "kg_selector/team/team_modes.h"
#include "ros/time.h"

namespace kg_ros {
namespace {

using kg_selector::Pathlet;
using kg_selector::RejectedPath;

double Now_s() { return ros::WallTime::now().toSec(); }

kg_selector::AgentOffer FromMessage(const kg_msgs::Candidates& message) {
  kg_selector::AgentOffer candidates;
  for (const kg_msgs::Pathlet& pathlet : message.pathlets) {
    candidates.pathlets.push_back(kg_ros::FromMessage(pathlet, message.agent));
  }
  candidates.proven = message.proven;
  candidates.note = message.note;
  candidates.bound = message.bound;
  if (candidates.pathlets.empty() && message.proven) {
    candidates.bound = -std::numeric_limits<double>::infinity();  // As planned.
  }
  return candidates;
}

// By waypoints, of a message or not.
template <typename PathletType>
std::vector<std::uint32_t> PlacesOf(const PathletType& pathlet) {
  std::vector<std::uint32_t> places;
  for (const auto& visit : pathlet.visits) {
    places.push_back(static_cast<std::uint32_t>(visit.via.size()));
    for (const auto& stop : visit.via) places.push_back(stop.waypoint);
    places.push_back(visit.waypoint);
  }
  return places;
}

}  // namespace

template <typename Message>
Message SelectorServer::Header() const {
  Message message;
  message.header.stamp = ros::Time::now();
  message.world_version = rules_->world_version;
  message.cycle = rules_->cycle;
  message.plan_run = run_;
  return message;
}

SelectorAnswer SelectorServer::KnowRun(const std::uint64_t run) {
  last_run_ = std::max(last_run_, run);
  if (team_ && !finished_) run_ = std::max(run_, last_run_ + 1);
  const bool was_waiting_for_it = !knows_last_run_;
  knows_last_run_ = true;
  return was_waiting_for_it ? Step() : SelectorAnswer{};
}

SelectorAnswer SelectorServer::Take(const kg_msgs::CoordinationRules& message) {
  if (rules_ && message.cycle <= rules_->cycle) return {};
  kg_selector::TeamRules rules = kg_ros::FromMessage(message);
  auto team = kg_selector::MakeCoordinator(rules, message.agents);
  team_rules_ = std::move(rules);
  rules_ = message;
  Begin(std::move(team));
  return Step();
}

void SelectorServer::Begin(std::unique_ptr<kg_selector::Coordinator> team) {
  team_ = std::move(team);
  run_ = last_run_ + 1;
  round_ = 0;
  finished_ = false;
  offered_.clear();
  pathlets_.clear();
  began_s_ = waiting_since_s_ = Now_s();
  complete_s_ = 0.0;
  for (const auto& [agent, candidates] : unmasked_) {
    if (candidates.cycle == rules_->cycle)
      Offer(candidates, FromMessage(candidates));
  }
}

SelectorAnswer SelectorServer::Take(const kg_msgs::Candidates& message) {
  // What makes no sense is not kept.
  kg_selector::AgentOffer candidates = FromMessage(message);
  if (message.round == 0) {
    kg_msgs::Candidates& known = unmasked_[message.agent];
    if (message.cycle < known.cycle) return {};
    const bool is_new = known.cycle != message.cycle;
    known = message;
    if (!rules_ || message.cycle != rules_->cycle) return {};
    // A planner that came back, or one that was given up: if it has something
    // new to say for this cycle, the team is put together again.
    if (finished_ && is_new) {
      Begin(kg_selector::MakeCoordinator(team_rules_, rules_->agents));
    }
    if (finished_) return {};
  }
  if (!rules_ || message.cycle != rules_->cycle || message.round != round_) {
    return {};
  }
  Offer(message, std::move(candidates));
  return Step();
}

void SelectorServer::Offer(const kg_msgs::Candidates& message,
                           kg_selector::AgentOffer candidates) {
  team_->Offer(message.agent, std::move(candidates));
  offered_[message.agent] = message;
  for (const kg_msgs::Pathlet& pathlet : message.pathlets) {
    pathlets_[{message.agent, PlacesOf(pathlet)}] = pathlet;
  }
  waiting_since_s_ = Now_s();
}

std::vector<std::string> SelectorServer::WaitingFor() const {
  if (!team_ || finished_) return {};
  return {team_->waiting_for().begin(), team_->waiting_for().end()};
}

SelectorAnswer SelectorServer::GiveUpWaiting() {
  for (const std::string& agent : WaitingFor()) {
    team_->Drop(agent, "no candidates came within the deadline");
  }
  return Step();
}

SelectorAnswer SelectorServer::Step() {
  if (!team_ || finished_ || !knows_last_run_) return {};
  if (!team_->waiting_for().empty()) return {};
  if (complete_s_ == 0.0) complete_s_ = Now_s();
  SelectorAnswer answer;
  if (!team_->Advance()) {
    answer.rejections = Ask();
    return answer;
  }
  finished_ = true;
  last_run_ = run_;
  answer.rejections = End();
  answer.assignments = Plan();
  return answer;
}

// Everybody who is waited for, and what for.
kg_msgs::Rejections SelectorServer::Ask() {
  kg_msgs::Rejections message = Header<kg_msgs::Rejections>();
  message.round = ++round_;
  waiting_since_s_ = Now_s();
  for (const std::string& agent : team_->waiting_for()) {
    AddAsk(agent, team_->RequestFor(agent), team_rules_, &message);
  }
  return message;
}

kg_msgs::Rejections SelectorServer::End() const {
  kg_msgs::Rejections message = Header<kg_msgs::Rejections>();
  message.round = 0;
  for (const RejectedPath& rejection : team_->outcome().rejections) {
    const auto offered = offered_.find(rejection.pathlet.agent);
    message.rejections.push_back(ToMessage(
        rejection, offered == offered_.end() ? "" : offered->second.agent_iri));
  }
  return message;
}

// The path as it was offered, worth what the team makes of it.
kg_msgs::Assignment SelectorServer::Assign(const Pathlet& pathlet) const {
  kg_msgs::Assignment assignment;
  assignment.agent = pathlet.agent;
  assignment.agent_iri = offered_.at(pathlet.agent).agent_iri;
  assignment.pathlet = pathlets_.at({pathlet.agent, PlacesOf(pathlet)});
  assignment.pathlet.rank = pathlet.rank;
  assignment.pathlet.reward = pathlet.reward;
  assignment.pathlet.seam_cost = pathlet.seam_cost;
  for (std::size_t i = 0; i < pathlet.visits.size(); ++i) {
    assignment.pathlet.visits[i].reward = pathlet.visits[i].reward;
    assignment.pathlet.visits[i].events = pathlet.visits[i].events;
  }
  return assignment;
}

kg_msgs::Assignments SelectorServer::Plan() {
  kg_msgs::Assignments plan = Header<kg_msgs::Assignments>();
  plan.rounds = round_;
  plan.mode = team_rules_.mode;
  plan.bound = FiniteOrUnknown(team_->outcome().bound);
  const kg_selector::PlanStability stability =
      kg_selector::ComputeStability(last_plan_, team_->outcome().committed);
  plan.stability = stability.share;
  plan.displacement_m = stability.displacement_m;
  last_plan_ = team_->outcome().committed;
  for (const Pathlet& pathlet : team_->outcome().committed) {
    plan.assignments.push_back(Assign(pathlet));
    plan.reward += pathlet.reward;
    plan.seam_cost += pathlet.seam_cost;
  }
  for (const auto& [agent, why] : team_->outcome().unassigned) {
    const auto offered = offered_.find(agent);
    const bool has_note =
        offered != offered_.end() && !offered->second.note.empty();
    plan.unassigned.push_back(agent + ": " +
                              (has_note ? offered->second.note : why));
  }
  plan.stages = {
      Stage("plan", complete_s_ - began_s_, offered_.size()),
      Stage("select", Now_s() - complete_s_, plan.assignments.size())};
  return plan;
}

}  // namespace kg_ros
