#include "kg_engine/state/start_state.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include "kg_compiler/compile/as_sent.h"
#include "kg_engine/state/mission_state.h"
#include "kg_engine/terms/artifact_names.h"

namespace kg_engine {
namespace {

using kg_compiler::Compilation;

// Minimum remaining share of a window's duration.
constexpr double kLeastShareToPlan = 0.25;

// Rounds positions as in messages, so that in-process planning uses the same
// input as a planner node.
void TakeAsSent(Compilation* compilation) {
  for (kg_compiler::SeamRules& rules : compilation->rules) {
    rules.start = kg_compiler::AsSent(rules.start);
    for (kg_compiler::WindowRules& window : rules.windows) {
      if (window.committed) {
        window.committed = kg_compiler::AsSent(*window.committed);
      }
      for (kg_compiler::EventRule& event : window.events) {
        event.position = kg_compiler::AsSent(event.position);
      }
    }
  }
}

double Used_j(const std::vector<ExecutedVisit>& executed,
              const std::string& agent) {
  double used_j = 0.0;
  for (const ExecutedVisit& past : executed) {
    if (past.agent == agent) used_j += past.visit.cost.energy_j;
  }
  return used_j;
}

// Limits energy to the reported remainder and to the budget minus the use of
// past stops; a fact may have changed the budget meanwhile.
void LimitEnergy(const StartState& start, kg_compiler::SeamRules* rules) {
  const double used_j = Used_j(start.executed, rules->agent_id);
  rules->energy_budget_j = std::max(0.0, rules->energy_budget_j - used_j);
  const auto pose = start.fleet.poses().find(rules->agent_id);
  if (pose == start.fleet.poses().end()) return;
  const double left_j = pose->second.energy_left_j;
  if (std::isnan(left_j)) return;
  rules->energy_budget_j =
      std::min(rules->energy_budget_j, std::max(0.0, left_j));
}

// Rules that start from a reported state derive from it and from the report
// that defines mission time.
void CiteReports(const StartState& start, kg_compiler::SeamRules* rules) {
  rules->start_iri = StateNodeOf(rules->agent_id, start.cycle).text;
  rules->read_facts.push_back(
      StateNodeOf(start.fleet.Clock(), start.cycle).text);
}

void StartFromPoses(const StartState& start, Compilation* compilation) {
  const FleetState& fleet = start.fleet;
  for (kg_compiler::SeamRules& rules : compilation->rules) {
    const auto pose = fleet.poses().find(rules.agent_id);
    if (pose == fleet.poses().end() || rules.windows.empty()) continue;
    if (pose->second.observed) CiteReports(start, &rules);
    rules.start = pose->second.position;
    rules.start_heading_rad = pose->second.heading_rad;
    kg_compiler::WindowRules& first = rules.windows.front();
    const double duration_s = first.end_s - first.begin_s;
    first.begin_s = fleet.time_s();
    first.base_travel_m *= (first.end_s - first.begin_s) / duration_s;
  }
}

void CloseVisitedEvents(const std::vector<ExecutedVisit>& executed,
                        Compilation* compilation) {
  std::map<std::string, std::set<std::string>> visitors;  // Visitors, by event.
  for (const ExecutedVisit& past : executed) {
    for (const std::string& event : past.visit.events) {
      visitors[event].insert(past.agent_iri);
    }
  }
  std::map<std::string, int>& capacity =
      compilation->coordination.event_capacity;
  for (const auto& [event, agents] : visitors) {
    const auto left = capacity.find(event);
    if (left == capacity.end()) continue;
    left->second = std::max(0, left->second - static_cast<int>(agents.size()));
  }
  for (kg_compiler::SeamRules& rules : compilation->rules) {
    const auto is_closed = [&](const kg_compiler::EventRule& event) {
      const auto left = capacity.find(event.iri);
      return visitors[event.iri].count(rules.agent_iri) > 0 ||
             (left != capacity.end() && left->second == 0);
    };
    for (kg_compiler::WindowRules& window : rules.windows) {
      auto& events = window.events;
      events.erase(std::remove_if(events.begin(), events.end(), is_closed),
                   events.end());
    }
  }
}

void Commit(const PlanInForce& plan, kg_compiler::SeamRules* rules) {
  if (!(rules->churn_weight > 0.0)) return;
  bool any = false;
  for (kg_compiler::WindowRules& window : rules->windows) {
    const auto place = plan.places.find({rules->agent_id, window.window});
    if (place == plan.places.end()) continue;
    window.committed = place->second;
    any = true;
  }
  if (!any) return;
  rules->read_facts.push_back(CommitmentNode(plan.run, rules->agent_id).text);
}

}  // namespace

int FirstWindowToPlan(const StartState& start,
                      const kg_mission::Mission& mission) {
  const int current = start.fleet.CurrentWindow(mission);
  const int count = static_cast<int>(mission.windows.size());
  if (current + 1 >= count) return current;
  const kg_mission::TimeWindow& window = mission.windows[current];
  const double left_s = window.end_s - start.fleet.time_s();
  const bool worth_it = left_s >= kLeastShareToPlan * window.duration_s();
  return worth_it ? current : current + 1;
}

std::shared_ptr<const Compilation> StartFrom(const StartState& start,
                                             const Compilation& compilation) {
  auto started = std::make_shared<Compilation>(compilation);
  for (kg_compiler::SeamRules& rules : started->rules) {
    LimitEnergy(start, &rules);
    Commit(start.in_force, &rules);
  }
  StartFromPoses(start, started.get());
  CloseVisitedEvents(start.executed, started.get());
  TakeAsSent(started.get());
  return started;
}

StartState StartOf(const kg_core::GraphView& view,
                   const kg_mission::Mission& mission) {
  const MissionState state = LoadState(view);
  StartState start;
  start.fleet.Reset(mission);
  if (!state.mission_folder.empty()) {
    start.fleet.Restore(state.poses, state.mission_time_s);
    start.fleet.Follow(mission);
    start.executed = ReadExecuted(view, state.plan_run, mission);
    start.in_force = {state.plan_run,
                      ReadPlanned(view, state.plan_run, mission)};
  }
  start.cycle = state.cycle;
  return start;
}

}  // namespace kg_engine
