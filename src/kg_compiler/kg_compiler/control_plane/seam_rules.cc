#include "kg_compiler/control_plane/seam_rules.h"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <tuple>

#include "kg_base/common/input_error.h"
#include "kg_base/common/sha256.h"
#include "kg_base/common/units.h"
#include "kg_compiler/control_plane/seam_cost.h"
#include "kg_mission/mission/source_quantities.h"

namespace kg_compiler {
namespace {

constexpr int kMaxWaypoints = 20;

// Passes facts through and records their IRIs, so that the cited facts are
// exactly those read.
class FactReading {
 public:
  template <typename Fact>
  const Fact& operator()(const Fact& fact) {
    iris_.insert(fact.iri);
    return fact;
  }
  std::vector<std::string> Take() const { return {iris_.begin(), iris_.end()}; }

 private:
  std::set<std::string> iris_;
};

MotionModel Motion(const kg_mission::Capabilities& capabilities,
                   kg_mission::Mobility mobility) {
  MotionModel motion;
  motion.cruise_mps = capabilities.cruise_mps;
  motion.max_mps = capabilities.max_mps;
  motion.boost_gain = capabilities.boost_gain;
  motion.energy_per_m_j = capabilities.energy_per_m_j;
  motion.hotel_load_w = capabilities.hotel_load_w;
  if (mobility == kg_mission::Mobility::kHover) {
    motion.rest_mps = capabilities.cruise_mps;
  }
  return motion;
}

SeamWeights Weights(const kg_mission::Policy& policy) {
  SeamWeights weights;
  weights.time_per_s = policy.lambda_time_per_s;
  weights.energy_per_j = policy.lambda_energy_per_j;
  weights.risk_per_s = policy.lambda_risk / kg_base::kSecondsPerHour;
  weights.uncertainty = policy.lambda_uncertainty;
  weights.isolation = policy.isolation_weight;
  weights.turn_per_rad = policy.lambda_turn_per_rad;
  if (policy.lambda_fields.empty()) return weights;
  for (const kg_mission::SourceQuantity& field : kg_mission::CostQuantities()) {
    const auto lambda = policy.lambda_fields.find(field.name);
    weights.field_per_s.push_back(
        lambda == policy.lambda_fields.end() ? 0.0 : lambda->second);
  }
  return weights;
}

// Copies the policy's rules for selecting paths.
void TakePathRules(const kg_mission::Policy& policy, SeamRules* rules) {
  rules->hazard_range_m = policy.hazard_range_m;
  rules->hazard_budget_s =
      policy.hazard_budget_s.value_or(std::numeric_limits<double>::infinity());
  rules->diverse = policy.diverse_paths;
  rules->minimum_difference = policy.minimum_difference;
  rules->churn_weight = policy.churn_weight;
}

bool IsActive(const kg_mission::Event& event, int window) {
  return std::find(event.windows.begin(), event.windows.end(), window) !=
         event.windows.end();
}

WindowRules CompileWindow(const kg_mission::Mission& mission,
                          const kg_mission::Capabilities& capabilities,
                          const kg_mission::TimeWindow& window) {
  WindowRules rules;
  rules.window = window.index;
  rules.iri = window.iri;
  rules.begin_s = window.begin_s;
  rules.end_s = window.end_s;
  rules.confidence = window.confidence;
  rules.base_travel_m = capabilities.base_travel_m.value_or(
      capabilities.cruise_mps * window.duration_s());
  for (const kg_mission::Event& event : mission.events) {
    if (!IsActive(event, window.index)) continue;
    rules.events.push_back({event.iri, event.position,
                            event.value * window.confidence, event.radius_m});
  }
  return rules;
}

void HashNumbers(std::initializer_list<double> values, kg_base::Hasher* hash) {
  for (const double value : values) hash->Add(value);
}

void HashWindow(const WindowRules& window, kg_base::Hasher* hash) {
  hash->Add(window.iri);
  HashNumbers({static_cast<double>(window.window), window.begin_s, window.end_s,
               window.confidence, window.base_travel_m,
               static_cast<double>(window.events.size())},
              hash);
  for (const EventRule& event : window.events) {
    hash->Add(event.iri);
    HashNumbers({event.position.lon_deg, event.position.lat_deg, event.reward,
                 event.radius_m},
                hash);
  }
  HashCommitted(window, hash);
}

auto Tie(const EventRule& e) {
  return std::tie(e.iri, e.position.lon_deg, e.position.lat_deg, e.reward,
                  e.radius_m);
}

auto Tie(const WindowRules& w) {
  return std::tie(w.window, w.iri, w.begin_s, w.end_s, w.confidence,
                  w.base_travel_m, w.events, w.tensor_hash, w.field_hash,
                  w.committed);
}

auto Tie(const MotionModel& m) {
  return std::tie(m.cruise_mps, m.max_mps, m.boost_gain, m.energy_per_m_j,
                  m.hotel_load_w, m.rest_mps);
}

auto Tie(const SeamWeights& w) {
  return std::tie(w.time_per_s, w.energy_per_j, w.risk_per_s, w.uncertainty,
                  w.isolation, w.field_per_s, w.turn_per_rad);
}

auto TieOwn(const SeamRules& r) {
  return std::tie(r.agent_iri, r.agent_id, r.energy_budget_j, r.hazard_budget_s,
                  r.sensor_radius_m, r.spacing_m, r.max_waypoints, r.candidates,
                  r.diverse, r.minimum_difference, r.churn_weight,
                  r.hazard_range_m, r.movement_mode, r.start.lon_deg,
                  r.start.lat_deg, r.start_heading_rad);
}

}  // namespace

bool operator==(const EventRule& a, const EventRule& b) {
  return Tie(a) == Tie(b);
}

bool operator==(const WindowRules& a, const WindowRules& b) {
  return Tie(a) == Tie(b);
}

bool SameButForWindows(const SeamRules& a, const SeamRules& b) {
  return TieOwn(a) == TieOwn(b) && Tie(a.motion) == Tie(b.motion) &&
         Tie(a.weights) == Tie(b.weights) &&
         std::equal(a.windows.begin(), a.windows.end(), b.windows.begin(),
                    b.windows.end(),
                    [](const WindowRules& x, const WindowRules& y) {
                      return x.window == y.window;
                    });
}

SeamRules CompileSeamRules(const kg_mission::Mission& mission,
                           const kg_mission::Agent& agent, int first_window) {
  FactReading read;
  const kg_mission::CoordinationFacts& team = read(mission).coordination;
  const kg_mission::Capabilities& capabilities = read(agent.capabilities);
  SeamRules rules;
  rules.agent_iri = read(agent).iri;
  rules.agent_id = agent.id;
  rules.motion = Motion(capabilities, agent.mobility);
  const kg_mission::Policy& policy = read(agent.policy);
  rules.weights = Weights(policy);
  TakePathRules(policy, &rules);
  rules.movement_mode = MovementModeOf(team.movement_mode);
  // Energy left at the start if stated, capped by the agent's budget.
  rules.energy_budget_j =
      std::min(capabilities.energy_budget_j,
               agent.start_energy_j.value_or(capabilities.energy_budget_j));
  rules.sensor_radius_m = capabilities.sensor_radius_m;
  rules.spacing_m = team.waypoint_spacing_m;
  rules.max_waypoints = std::min(team.waypoints_per_window, kMaxWaypoints);
  rules.candidates = team.candidates_per_agent;
  rules.start = agent.start;
  rules.start_heading_rad = agent.start_heading_rad;
  rules.start_iri = agent.start_iri;
  for (const kg_mission::TimeWindow& window : mission.windows) {
    if (window.index < first_window) continue;
    rules.windows.push_back(CompileWindow(mission, capabilities, window));
  }
  rules.read_facts = read.Take();
  return rules;
}

bool ChargesTurns(const SeamRules& rules, const WindowRules& window) {
  return rules.weights.turn_per_rad != 0.0 && !rules.windows.empty() &&
         window.window == rules.windows.front().window;
}

void HashStartHeading(const SeamRules& rules, const WindowRules& window,
                      kg_base::Hasher* hash) {
  if (!ChargesTurns(rules, window)) return;
  hash->Add("heading");
  hash->Add(rules.start_heading_rad);
}

void HashCommitted(const WindowRules& window, kg_base::Hasher* hash) {
  if (!window.committed) return;
  hash->Add("committed");
  HashNumbers({window.committed->lon_deg, window.committed->lat_deg}, hash);
}

void HashWeights(const SeamWeights& weights, kg_base::Hasher* hash) {
  for (const SeamTerm& term : SeamTerms()) {
    const double weight = term.weight(weights);
    if (term.is_optional && weight == 0.0) continue;
    if (term.is_optional) hash->Add(term.name);
    hash->Add(weight);
    // The isolation weight is not a term of its own: it scales I within the
    // risk term.
    if (term.name == "uncertainty") hash->Add(weights.isolation);
  }
}

void HashMotion(const MotionModel& motion, kg_base::Hasher* hash) {
  HashNumbers({motion.cruise_mps, motion.max_mps, motion.boost_gain,
               motion.energy_per_m_j, motion.hotel_load_w},
              hash);
  if (motion.rest_mps == 0.0) return;
  hash->Add("rest");
  hash->Add(motion.rest_mps);
}

std::string SeamRulesHash(const SeamRules& rules) {
  kg_base::Hasher hash;
  hash.Add(rules.agent_iri);
  hash.Add(rules.agent_id);
  HashMotion(rules.motion, &hash);
  HashWeights(rules.weights, &hash);
  HashNumbers(
      {rules.energy_budget_j, rules.hazard_budget_s, rules.sensor_radius_m,
       rules.spacing_m, static_cast<double>(rules.max_waypoints),
       static_cast<double>(rules.candidates),
       static_cast<double>(rules.diverse),
       static_cast<double>(rules.minimum_difference), rules.churn_weight,
       rules.hazard_range_m, rules.start.lon_deg, rules.start.lat_deg,
       rules.start_heading_rad},
      &hash);
  hash.Add(Name(rules.movement_mode));
  for (const WindowRules& window : rules.windows) HashWindow(window, &hash);
  return hash.Hex();
}

std::vector<std::string> SeamRulesSources(const SeamRules& rules) {
  std::set<std::string> sources(rules.read_facts.begin(),
                                rules.read_facts.end());
  sources.insert(rules.start_iri);
  for (const WindowRules& window : rules.windows) {
    sources.insert(window.iri);
    for (const EventRule& event : window.events) sources.insert(event.iri);
  }
  sources.erase("");
  return {sources.begin(), sources.end()};
}

}  // namespace kg_compiler
