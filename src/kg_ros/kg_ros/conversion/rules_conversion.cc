#include "kg_ros/conversion/rules_conversion.h"

#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "kg_base/common/input_error.h"
#include "kg_mission/mission/option_names.h"
#include "kg_ros/conversion/message_units.h"
#include "kg_selector/team/team_modes.h"

namespace kg_ros {
namespace {

using kg_base::InputError;

void RequireAtLeast(double value, double least, const char* field) {
  if (std::isfinite(value) && value >= least) return;
  throw InputError(std::string(field) +
                   " must be a number >= " + std::to_string(least));
}

void RequireAtMost(double value, double most, const char* field) {
  if (value <= most) return;
  throw InputError(std::string(field) + " must be at most " +
                   std::to_string(most));
}

void RequireOneOf(const std::string& value,
                  const std::vector<std::string>& names, const char* field) {
  std::string expected;
  for (const std::string& name : names) {
    if (value == name) return;
    expected += (expected.empty() ? "'" : ", '") + name + "'";
  }
  throw InputError(std::string(field) + " '" + value + "': expected one of " +
                   expected);
}

kg_msgs::WindowRules ToMessage(const kg_compiler::WindowRules& rules) {
  kg_msgs::WindowRules message;
  message.window = rules.window;
  message.iri = rules.iri;
  message.begin = ToRosTime(rules.begin_s);
  message.end = ToRosTime(rules.end_s);
  message.confidence = rules.confidence;
  message.base_travel_m = rules.base_travel_m;
  message.tensor_hash = rules.tensor_hash;
  message.field_hash = rules.field_hash;
  message.is_committed = rules.committed.has_value();
  if (rules.committed) {
    message.committed_lon_rad = kg_base::DegToRad(rules.committed->lon_deg);
    message.committed_lat_rad = kg_base::DegToRad(rules.committed->lat_deg);
  }
  for (const kg_compiler::EventRule& event : rules.events) {
    message.events.emplace_back();
    message.events.back().iri = event.iri;
    SetPosition(event.position, &message.events.back());
    message.events.back().reward = event.reward;
    message.events.back().radius_m = event.radius_m;
  }
  return message;
}

std::optional<kg_base::LonLat> CommittedPlace(
    const kg_msgs::WindowRules& message) {
  if (!message.is_committed) return std::nullopt;
  if (!std::isfinite(message.committed_lon_rad) ||
      !(std::abs(message.committed_lat_rad) <= kg_base::kPi / 2)) {
    throw InputError("WindowRules.committed must be a place on WGS84");
  }
  return kg_base::LonLat{kg_base::RadToDeg(message.committed_lon_rad),
                         kg_base::RadToDeg(message.committed_lat_rad)};
}

kg_compiler::WindowRules FromMessage(const kg_msgs::WindowRules& message) {
  kg_compiler::WindowRules rules;
  rules.window = message.window;
  rules.iri = message.iri;
  rules.begin_s = FromRosTime(message.begin);
  rules.end_s = FromRosTime(message.end);
  rules.confidence = message.confidence;
  rules.base_travel_m = message.base_travel_m;
  rules.tensor_hash = message.tensor_hash;
  rules.field_hash = message.field_hash;
  rules.committed = CommittedPlace(message);
  RequireAtLeast(rules.base_travel_m, 0.0, "WindowRules.base_travel_m");
  if (!(rules.end_s > rules.begin_s)) {
    throw InputError("WindowRules.end must come after begin");
  }
  for (const kg_msgs::EventRule& event : message.events) {
    RequireAtLeast(event.reward, 0.0, "EventRule.reward");
    rules.events.push_back(
        {event.iri, GetPosition(event), event.reward, event.radius_m});
  }
  return rules;
}

// Checks the path rules of SeamRules: budgets, choice of paths.
void CheckPathRules(const kg_msgs::SeamRules& message) {
  if (!std::isnan(message.hazard_budget_s)) {
    RequireAtLeast(message.hazard_budget_s, 0.0, "SeamRules.hazard_budget_s");
  }
  RequireOneOf(message.path_choice, {"best", "diverse"},
               "SeamRules.path_choice");
  RequireAtLeast(message.minimum_difference, 1, "SeamRules.minimum_difference");
  RequireAtLeast(message.churn_weight, 0.0, "SeamRules.churn_weight");
}

void TakePathRules(const kg_msgs::SeamRules& message,
                   kg_compiler::SeamRules* rules) {
  CheckPathRules(message);
  rules->hazard_budget_s = std::isnan(message.hazard_budget_s)
                               ? std::numeric_limits<double>::infinity()
                               : message.hazard_budget_s;
  rules->diverse = message.path_choice == "diverse";
  rules->minimum_difference = static_cast<int>(message.minimum_difference);
  rules->churn_weight = message.churn_weight;
}

void WritePathRules(const kg_compiler::SeamRules& rules,
                    kg_msgs::SeamRules* message) {
  message->hazard_budget_s = FiniteOrUnknown(rules.hazard_budget_s);
  message->path_choice = rules.diverse ? "diverse" : "best";
  message->minimum_difference = rules.minimum_difference;
  message->churn_weight = rules.churn_weight;
}

// Throws if the rules of selection are invalid.
void CheckChoice(const kg_msgs::CoordinationRules& message) {
  RequireOneOf(message.mode, kg_selector::TeamModeNames(),
               "CoordinationRules.mode");
  RequireAtLeast(message.gap_goal, 0.0, "CoordinationRules.gap_goal");
  RequireAtMost(message.gap_goal, 1.0, "CoordinationRules.gap_goal");
  if (!std::isfinite(message.auction_epsilon) ||
      !(message.auction_epsilon > 0.0)) {
    throw InputError("CoordinationRules.auction_epsilon must be a number > 0");
  }
  RequireAtLeast(message.time_limit_s, 0.0, "CoordinationRules.time_limit_s");
  RequireOneOf(message.fairness,
               {std::begin(kg_mission::kFairnessNames),
                std::end(kg_mission::kFairnessNames)},
               "CoordinationRules.fairness");
  RequireAtLeast(message.fairness_weight, 0.0,
                 "CoordinationRules.fairness_weight");
}

std::map<std::string, double> BudgetsOf(
    const kg_msgs::CoordinationRules& message) {
  if (message.energy_budget_j.size() != message.agents.size()) {
    throw InputError(
        "CoordinationRules.energy_budget_j must have a budget for each of "
        "agents");
  }
  std::map<std::string, double> budgets_j;
  for (std::size_t i = 0; i < message.agents.size(); ++i) {
    RequireAtLeast(message.energy_budget_j[i], 0.0,
                   "CoordinationRules.energy_budget_j");
    budgets_j[message.agents[i]] = message.energy_budget_j[i];
  }
  return budgets_j;
}

}  // namespace

kg_msgs::WindowInfo ToMessage(const kg_mission::TimeWindow& window) {
  kg_msgs::WindowInfo message;
  message.iri = window.iri;
  message.index = window.index;
  message.begin = ToRosTime(window.begin_s);
  message.end = ToRosTime(window.end_s);
  message.confidence = window.confidence;
  return message;
}

kg_msgs::SeamRules ToMessage(const kg_compiler::SeamRules& rules,
                             const std::uint64_t cycle) {
  kg_msgs::SeamRules message;
  message.world_version = rules.world_version;
  message.cycle = cycle;
  message.agent = rules.agent_id;
  message.agent_iri = rules.agent_iri;
  message.cruise_mps = rules.motion.cruise_mps;
  message.max_mps = rules.motion.max_mps;
  message.boost_gain = rules.motion.boost_gain;
  message.energy_per_m_j = rules.motion.energy_per_m_j;
  message.hotel_load_w = rules.motion.hotel_load_w;
  message.rest_mps = rules.motion.rest_mps;
  message.energy_budget_j = rules.energy_budget_j;
  message.lambda_time_per_s = rules.weights.time_per_s;
  message.lambda_energy_per_j = rules.weights.energy_per_j;
  message.lambda_risk_per_s = rules.weights.risk_per_s;
  message.lambda_uncertainty = rules.weights.uncertainty;
  message.isolation_weight = rules.weights.isolation;
  message.lambda_fields = rules.weights.field_per_s;
  message.lambda_turn_per_rad = rules.weights.turn_per_rad;
  message.hazard_range_m = rules.hazard_range_m;
  message.movement_mode = kg_compiler::Name(rules.movement_mode);
  message.sensor_radius_m = rules.sensor_radius_m;
  message.spacing_m = rules.spacing_m;
  message.max_waypoints = rules.max_waypoints;
  message.candidates = rules.candidates;
  WritePathRules(rules, &message);
  message.start_lon_rad = kg_base::DegToRad(rules.start.lon_deg);
  message.start_lat_rad = kg_base::DegToRad(rules.start.lat_deg);
  message.start_heading_rad = rules.start_heading_rad;
  for (const kg_compiler::WindowRules& window : rules.windows) {
    message.windows.push_back(ToMessage(window));
  }
  return message;
}

kg_compiler::SeamRules FromMessage(const kg_msgs::SeamRules& message) {
  RequireAtLeast(message.cruise_mps, 0.0, "SeamRules.cruise_mps");
  RequireAtLeast(message.max_mps, message.cruise_mps, "SeamRules.max_mps");
  RequireAtLeast(message.energy_budget_j, 0.0, "SeamRules.energy_budget_j");
  RequireAtLeast(message.sensor_radius_m, 0.0, "SeamRules.sensor_radius_m");
  RequireAtLeast(message.isolation_weight, 0.0, "SeamRules.isolation_weight");
  RequireAtLeast(message.hazard_range_m, 0.0, "SeamRules.hazard_range_m");
  RequireAtLeast(message.rest_mps, 0.0, "SeamRules.rest_mps");
  RequireAtLeast(message.lambda_turn_per_rad, 0.0,
                 "SeamRules.lambda_turn_per_rad");
  for (const double lambda : message.lambda_fields) {
    RequireAtLeast(lambda, 0.0, "SeamRules.lambda_fields");
  }
  RequireAtLeast(message.max_waypoints, 1, "SeamRules.max_waypoints");
  RequireAtLeast(message.candidates, 1, "SeamRules.candidates");
  kg_compiler::SeamRules rules;
  rules.agent_iri = message.agent_iri;
  rules.agent_id = message.agent;
  rules.world_version = message.world_version;
  rules.motion = {message.cruise_mps,   message.max_mps,
                  message.boost_gain,   message.energy_per_m_j,
                  message.hotel_load_w, message.rest_mps};
  rules.weights = {message.lambda_time_per_s,  message.lambda_energy_per_j,
                   message.lambda_risk_per_s,  message.lambda_uncertainty,
                   message.isolation_weight,   message.lambda_fields,
                   message.lambda_turn_per_rad};
  rules.energy_budget_j = message.energy_budget_j;
  rules.sensor_radius_m = message.sensor_radius_m;
  rules.spacing_m = message.spacing_m;
  rules.max_waypoints = static_cast<int>(message.max_waypoints);
  rules.candidates = static_cast<int>(message.candidates);
  TakePathRules(message, &rules);
  rules.hazard_range_m = message.hazard_range_m;
  rules.movement_mode = kg_compiler::MovementModeOf(message.movement_mode);
  rules.start = {kg_base::RadToDeg(message.start_lon_rad),
                 kg_base::RadToDeg(message.start_lat_rad)};
  rules.start_heading_rad = message.start_heading_rad;
  for (const kg_msgs::WindowRules& window : message.windows) {
    rules.windows.push_back(FromMessage(window));
  }
  return rules;
}

Coordination CoordinationOf(const kg_compiler::Compilation& compilation,
                            const std::uint64_t cycle) {
  Coordination coordination;
  coordination.world_version = compilation.world_version;
  coordination.cycle = cycle;
  coordination.rules = compilation.coordination;
  for (const kg_mission::TimeWindow& window : compilation.mission.windows) {
    if (window.index >= compilation.first_window) {
      coordination.windows.push_back(window);
    }
  }
  for (const kg_compiler::SeamRules& rules : compilation.rules) {
    coordination.agents.push_back(rules.agent_id);
    coordination.energy_budget_j.push_back(rules.energy_budget_j);
  }
  return coordination;
}

kg_msgs::CoordinationRules ToMessage(const Coordination& coordination) {
  const kg_mission::CoordinationFacts& facts = coordination.rules.facts;
  kg_msgs::CoordinationRules message;
  message.world_version = coordination.world_version;
  message.cycle = coordination.cycle;
  message.agents = coordination.agents;
  message.energy_budget_j = coordination.energy_budget_j;
  for (const kg_mission::TimeWindow& window : coordination.windows) {
    message.windows.push_back(ToMessage(window));
  }
  message.mode = facts.mode;
  message.gap_goal = facts.gap_goal;
  message.auction_epsilon = facts.auction_epsilon;
  message.time_limit_s = facts.select_limit_s;
  message.separation_m = facts.separation_m;
  message.separation_is_hard = facts.separation_is_hard;
  message.separation_weight_per_m = facts.separation_weight;
  message.fairness = facts.fairness;
  message.fairness_weight = facts.fairness_weight;
  message.max_rounds = facts.max_rounds;
  for (const auto& [iri, capacity] : coordination.rules.event_capacity) {
    message.events.emplace_back();
    message.events.back().iri = iri;
    message.events.back().capacity = capacity;
    const auto windows = coordination.rules.event_windows.find(iri);
    if (windows == coordination.rules.event_windows.end()) continue;
    message.events.back().windows.assign(windows->second.begin(),
                                         windows->second.end());
  }
  return message;
}

kg_selector::TeamRules FromMessage(const kg_msgs::CoordinationRules& message) {
  RequireAtLeast(message.separation_m, 0.0, "CoordinationRules.separation_m");
  RequireAtLeast(message.separation_weight_per_m, 0.0,
                 "CoordinationRules.separation_weight_per_m");
  CheckChoice(message);
  kg_selector::TeamRules rules;
  rules.mode = message.mode;
  rules.gap_goal = message.gap_goal;
  rules.auction_epsilon = message.auction_epsilon;
  rules.time_limit_s = message.time_limit_s;
  rules.fairness = message.fairness;
  rules.fairness_weight = message.fairness_weight;
  rules.energy_budget_j = BudgetsOf(message);
  rules.separation_m = message.separation_m;
  rules.separation_is_hard = message.separation_is_hard;
  rules.separation_weight_per_m = message.separation_weight_per_m;
  rules.max_rounds = static_cast<int>(message.max_rounds);
  for (const kg_msgs::WindowInfo& window : message.windows) {
    rules.window_end_s[window.index] = FromRosTime(window.end);
  }
  for (const kg_msgs::EventCapacity& event : message.events) {
    rules.event_capacity[event.iri] = static_cast<int>(event.capacity);
    rules.event_windows[event.iri] = {event.windows.begin(),
                                      event.windows.end()};
  }
  return rules;
}

kg_engine::TeamTask ToTask(const kg_msgs::CoordinationRules& message) {
  return {message.world_version, message.cycle, message.agents,
          FromMessage(message)};
}

}  // namespace kg_ros
