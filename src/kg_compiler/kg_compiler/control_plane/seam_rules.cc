#include "kg_compiler/control_plane/seam_rules.h"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <tuple>

#include "kg_core/base/input_error.h"
#include "kg_core/base/sha256.h"
#include "kg_core/base/units.h"

namespace kg_compiler {
namespace {

constexpr int kMostWaypoints = 20;

// Hands out facts and notes them down, so that what is cited is what was read.
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

MotionModel Motion(const kg_core::Capabilities& capabilities) {
  MotionModel motion;
  motion.cruise_mps = capabilities.cruise_mps;
  motion.max_mps = capabilities.max_mps;
  motion.boost_gain = capabilities.boost_gain;
  motion.energy_per_m_j = capabilities.energy_per_m_j;
  motion.hotel_load_w = capabilities.hotel_load_w;
  return motion;
}

SeamWeights Weights(const kg_core::Policy& policy) {
  SeamWeights weights;
  weights.time_per_s = policy.lambda_time_per_s;
  weights.energy_per_j = policy.lambda_energy_per_j;
  weights.risk_per_s = policy.lambda_risk / kg_core::kSecondsPerHour;
  weights.uncertainty = policy.lambda_uncertainty;
  weights.isolation = policy.isolation_weight;
  return weights;
}

// Which paths are offered, beside their terms.
void TakePathRules(const kg_core::Policy& policy, SeamRules* rules) {
  rules->hazard_range_m = policy.hazard_range_m;
  rules->hazard_budget_s =
      policy.hazard_budget_s.value_or(std::numeric_limits<double>::infinity());
  rules->diverse = policy.diverse_paths;
  rules->minimum_difference = policy.minimum_difference;
  rules->churn_weight = policy.churn_weight;
}

bool IsActive(const kg_core::Event& event, int window) {
  return std::find(event.windows.begin(), event.windows.end(), window) !=
         event.windows.end();
}

WindowRules CompileWindow(const kg_core::Mission& mission,
                          const kg_core::Capabilities& capabilities,
                          const kg_core::TimeWindow& window) {
  WindowRules rules;
  rules.window = window.index;
  rules.iri = window.iri;
  rules.begin_s = window.begin_s;
  rules.end_s = window.end_s;
  rules.confidence = window.confidence;
  rules.base_travel_m = capabilities.base_travel_m.value_or(
      capabilities.cruise_mps * window.duration_s());
  for (const kg_core::Event& event : mission.events) {
    if (!IsActive(event, window.index)) continue;
    rules.events.push_back({event.iri, event.position,
                            event.value * window.confidence, event.radius_m});
  }
  return rules;
}

void HashNumbers(std::initializer_list<double> values, kg_core::Hasher* hash) {
  for (const double value : values) hash->Add(value);
}

void HashWindow(const WindowRules& window, kg_core::Hasher* hash) {
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
                  m.hotel_load_w);
}

auto Tie(const SeamWeights& w) {
  return std::tie(w.time_per_s, w.energy_per_j, w.risk_per_s, w.uncertainty,
                  w.isolation);
}

auto TieOwn(const SeamRules& r) {
  return std::tie(r.agent_iri, r.agent_id, r.energy_budget_j, r.hazard_budget_s,
                  r.sensor_radius_m, r.spacing_m, r.max_waypoints, r.candidates,
                  r.diverse, r.minimum_difference, r.churn_weight,
                  r.hazard_range_m, r.movement_mode, r.start.lon_deg,
                  r.start.lat_deg, r.start_heading_rad);
}

}  // namespace

const char* Name(MovementMode mode) {
  switch (mode) {
    case MovementMode::kHops:
      return "hops";
    case MovementMode::kEdges:
      return "edges";
  }
  throw std::logic_error("a movement mode without a name");
}

MovementMode MovementModeOf(const std::string& name) {
  for (const MovementMode mode : {MovementMode::kHops, MovementMode::kEdges}) {
    if (name == Name(mode)) return mode;
  }
  throw kg_core::InputError("movement mode '" + name +
                            "': expected 'hops' or 'edges'");
}

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

SeamRules CompileSeamRules(const kg_core::Mission& mission,
                           const kg_core::Agent& agent, int first_window) {
  FactReading read;
  const kg_core::CoordinationFacts& team = read(mission).coordination;
  const kg_core::Capabilities& capabilities = read(agent.capabilities);
  SeamRules rules;
  rules.agent_iri = read(agent).iri;
  rules.agent_id = agent.id;
  rules.motion = Motion(capabilities);
  const kg_core::Policy& policy = read(agent.policy);
  rules.weights = Weights(policy);
  TakePathRules(policy, &rules);
  rules.movement_mode = MovementModeOf(team.movement_mode);
  rules.energy_budget_j = capabilities.energy_budget_j;
  rules.sensor_radius_m = capabilities.sensor_radius_m;
  rules.spacing_m = team.waypoint_spacing_m;
  rules.max_waypoints = std::min(team.waypoints_per_window, kMostWaypoints);
  rules.candidates = team.candidates_per_agent;
  rules.start = agent.start;
  rules.start_heading_rad = agent.start_heading_rad;
  rules.start_iri = agent.start_iri;
  for (const kg_core::TimeWindow& window : mission.windows) {
    if (window.index < first_window) continue;
    rules.windows.push_back(CompileWindow(mission, capabilities, window));
  }
  rules.read_facts = read.Take();
  return rules;
}

void HashCommitted(const WindowRules& window, kg_core::Hasher* hash) {
  if (!window.committed) return;
  hash->Add("committed");
  HashNumbers({window.committed->lon_deg, window.committed->lat_deg}, hash);
}

std::string SeamRulesHash(const SeamRules& rules) {
  const MotionModel& motion = rules.motion;
  const SeamWeights& weights = rules.weights;
  kg_core::Hasher hash;
  hash.Add(rules.agent_iri);
  hash.Add(rules.agent_id);
  HashNumbers({motion.cruise_mps,
               motion.max_mps,
               motion.boost_gain,
               motion.energy_per_m_j,
               motion.hotel_load_w,
               weights.time_per_s,
               weights.energy_per_j,
               weights.risk_per_s,
               weights.uncertainty,
               weights.isolation,
               rules.energy_budget_j,
               rules.hazard_budget_s,
               rules.sensor_radius_m,
               rules.spacing_m,
               static_cast<double>(rules.max_waypoints),
               static_cast<double>(rules.candidates),
               static_cast<double>(rules.diverse),
               static_cast<double>(rules.minimum_difference),
               rules.churn_weight,
               rules.hazard_range_m,
               rules.start.lon_deg,
               rules.start.lat_deg,
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
