#include "kg_engine/planning/team_selector.h"

#include <algorithm>
#include <utility>

#include "kg_base/common/clock.h"
#include "kg_selector/team/plan_mission.h"
#include "kg_selector/team/stability.h"
#include "kg_selector/team/team_modes.h"

namespace kg_engine {
namespace {

using kg_base::Now_s;
using kg_selector::AgentCandidates;
using kg_selector::CommittedPlan;
using kg_selector::Pathlet;
using kg_selector::RejectedPath;
using kg_selector::RoundRequest;
using kg_selector::RunEnd;

}  // namespace

TeamTask ToTeamTask(const kg_compiler::Compilation& compilation,
                    const std::uint64_t cycle) {
  TeamTask task;
  task.world_version = compilation.world_version;
  task.cycle = cycle;
  for (const kg_compiler::SeamRules& rules : compilation.rules) {
    task.agents.push_back(rules.agent_id);
  }
  task.rules = kg_selector::ToTeamRules(compilation);
  return task;
}

template <typename Value>
Value TeamSelector::Header() const {
  Value value;
  value.time_s = Now_s();
  value.world_version = task_->world_version;
  value.cycle = task_->cycle;
  value.run = run_;
  return value;
}

SelectorAnswer TeamSelector::KnowRun(const std::uint64_t run) {
  last_run_ = std::max(last_run_, run);
  SelectorAnswer answer;
  if (team_ && !finished_ && run_ <= last_run_) {
    run_ = last_run_ + 1;
    if (round_ > 0) {
      request_.run = run_;
      answer.request = request_;
    }
  }
  const bool was_waiting_for_it = !knows_last_run_;
  knows_last_run_ = true;
  return was_waiting_for_it ? Step() : answer;
}

SelectorAnswer TeamSelector::Take(const TeamTask& task) {
  if (task_ && task.cycle <= task_->cycle) return {};
  auto team = kg_selector::MakeCoordinator(task.rules, task.agents);
  task_ = task;
  Begin(std::move(team));
  return Step();
}

void TeamSelector::Begin(std::unique_ptr<kg_selector::Coordinator> team) {
  team_ = std::move(team);
  run_ = last_run_ + 1;
  round_ = 0;
  finished_ = false;
  offered_.clear();
  began_s_ = waiting_since_s_ = Now_s();
  complete_s_ = 0.0;
  for (const auto& [agent, candidates] : unmasked_) {
    if (candidates.cycle == task_->cycle) Offer(candidates);
  }
}

SelectorAnswer TeamSelector::Take(const AgentCandidates& candidates) {
  // A planner that a later round ends repeats round 0 each time it returns:
  // that is no sign of life.
  const bool is_repeated = task_ && !finished_ &&
                           candidates.cycle == task_->cycle &&
                           candidates.round < round_;
  if (!is_repeated) deaths_.erase(candidates.agent);
  if (candidates.round == 0) {
    AgentCandidates& known = unmasked_[candidates.agent];
    if (candidates.cycle < known.cycle) return {};
    const bool is_new = known.cycle != candidates.cycle;
    known = candidates;
    if (!task_ || candidates.cycle != task_->cycle) return {};
    // A planner that returned or was given up: if it has a new answer for this
    // cycle, coordination restarts.
    if (finished_ && is_new) {
      Begin(kg_selector::MakeCoordinator(task_->rules, task_->agents));
    }
    if (finished_) return {};
  }
  if (!task_ || candidates.cycle != task_->cycle ||
      candidates.round != round_) {
    return {};
  }
  Offer(candidates);
  return Step();
}

void TeamSelector::Offer(const AgentCandidates& candidates) {
  team_->Offer(candidates.agent, candidates.found);
  offered_[candidates.agent] = {candidates.agent_iri, candidates.found.note};
  waiting_since_s_ = Now_s();
}

std::vector<std::string> TeamSelector::WaitingFor() const {
  if (!team_ || finished_) return {};
  return {team_->waiting_for().begin(), team_->waiting_for().end()};
}

SelectorAnswer TeamSelector::GiveUpWaiting() {
  for (const std::string& agent : WaitingFor()) {
    team_->Drop(agent, "no candidates came within the deadline");
  }
  return Step();
}

int TeamSelector::Deaths(const std::string& agent) const {
  const auto known = deaths_.find(agent);
  return known == deaths_.end() ? 0 : known->second;
}

SelectorAnswer TeamSelector::CountDeath(const std::string& agent) {
  ++deaths_[agent];
  return Step();
}

void TeamSelector::DropDeadPlanners() {
  for (const std::string& agent : WaitingFor()) {
    const int deaths = Deaths(agent);
    if (deaths < kMaxDeaths) continue;
    team_->Drop(agent, "planner for " + agent + " died " +
                           std::to_string(deaths) +
                           " times (respawned), planned without it");
  }
}

std::string TeamSelector::LastInput() const {
  if (!task_) return "none";
  std::string text = "cycle " + std::to_string(task_->cycle) +
                     ", world version " + std::to_string(task_->world_version) +
                     ", round " + std::to_string(round_);
  const std::map<int, double>& windows = task_->rules.window_end_s;
  if (windows.empty()) return text;
  return text + ", windows " + std::to_string(windows.begin()->first) + " to " +
         std::to_string(windows.rbegin()->first);
}

SelectorAnswer TeamSelector::Step() {
  if (!team_ || finished_ || !knows_last_run_) return {};
  DropDeadPlanners();
  if (!team_->waiting_for().empty()) return {};
  if (complete_s_ == 0.0) complete_s_ = Now_s();
  SelectorAnswer answer;
  if (!team_->Advance()) {
    answer.request = Ask();
    return answer;
  }
  finished_ = true;
  last_run_ = run_;
  answer.end = End();
  answer.plan = Plan();
  return answer;
}

// Request for all agents waited for.
RoundRequest TeamSelector::Ask() {
  RoundRequest request = Header<RoundRequest>();
  request.round = ++round_;
  waiting_since_s_ = Now_s();
  for (const std::string& agent : team_->waiting_for()) {
    kg_selector::AddAsk(agent, team_->RequestFor(agent), task_->rules,
                        &request);
  }
  request_ = request;
  return request;
}

RunEnd TeamSelector::End() const {
  RunEnd end = Header<RunEnd>();
  for (const RejectedPath& rejection : team_->outcome().rejections) {
    const auto offered = offered_.find(rejection.pathlet.agent);
    end.rejections.push_back(
        {offered == offered_.end() ? "" : offered->second.agent_iri,
         rejection});
  }
  return end;
}

CommittedPlan TeamSelector::Plan() {
  CommittedPlan plan = Header<CommittedPlan>();
  plan.rounds = static_cast<int>(round_);
  plan.mode = task_->rules.mode;
  plan.bound = team_->outcome().bound;
  const kg_selector::PlanStability stability =
      kg_selector::ComputeStability(last_plan_, team_->outcome().committed);
  plan.stability = stability.share;
  plan.displacement_m = stability.displacement_m;
  last_plan_ = team_->outcome().committed;
  for (const Pathlet& pathlet : team_->outcome().committed) {
    plan.assignments.push_back({offered_.at(pathlet.agent).agent_iri, pathlet});
    plan.reward += pathlet.reward;
    plan.seam_cost += pathlet.seam_cost;
  }
  // Use the planner's own reason for "no path".
  for (const auto& [agent, why] : team_->outcome().unassigned) {
    const auto offered = offered_.find(agent);
    const bool has_note =
        offered != offered_.end() && !offered->second.note.empty();
    plan.unassigned[agent] = has_note ? offered->second.note : why;
  }
  plan.stages = {{"plan", complete_s_ - began_s_, offered_.size()},
                 {"select", Now_s() - complete_s_, plan.assignments.size()}};
  return plan;
}

}  // namespace kg_engine
