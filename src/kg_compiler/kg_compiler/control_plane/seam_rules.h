// The control plane's rules for one agent, compiled from facts: capabilities,
// costs and rewards. Plain numbers in SI units; sent to the agent's planner,
// which applies them with nav_graph.h.

#ifndef KG_COMPILER_CONTROL_PLANE_SEAM_RULES_H_
#define KG_COMPILER_CONTROL_PLANE_SEAM_RULES_H_

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "kg_base/common/sha256.h"
#include "kg_base/geo/lon_lat.h"
#include "kg_compiler/control_plane/movement_mode.h"
#include "kg_compiler/control_plane/seam_weights.h"
#include "kg_compiler/traversal/motion.h"
#include "kg_mission/mission/mission.h"

namespace kg_compiler {

// A discrete point of interest in one window.
struct EventRule {
  std::string iri;
  kg_base::LonLat position;
  double reward = 0.0;    // Reward of one visit in this window: value * w_t.
  double radius_m = 0.0;  // A waypoint within this radius visits it.
};

struct WindowRules {
  int window = 0;
  std::string iri;
  double begin_s = 0.0;  // Unix seconds.
  double end_s = 0.0;
  double confidence = 1.0;
  double base_travel_m = 0.0;  // Distance through water per window (A17).
  std::vector<EventRule> events;
  std::string tensor_hash;  // Hash of the tensor these rules apply to.
  std::string field_hash;
  // End of this window in the current plan, if the policy penalises changes.
  std::optional<kg_base::LonLat> committed = std::nullopt;
};

struct SeamRules {
  std::string agent_iri;
  std::string agent_id;
  std::uint64_t world_version = 0;
  MotionModel motion;
  SeamWeights weights;
  double energy_budget_j = 0.0;  // Remaining energy for all windows below.
  // Upper bound of the sum of hazard_s + isolation_s over all windows below.
  double hazard_budget_s = std::numeric_limits<double>::infinity();
  double sensor_radius_m = 0.0;  // Footprint of a visit: PR's disc.
  double spacing_m = 0.0;        // Least distance between waypoints.
  int max_waypoints = 20;        // Per window.
  int candidates = 10;           // K.
  bool diverse = false;          // K differing paths instead of the K best.
  int minimum_difference = 1;    // Windows in which two such paths differ.
  // Penalty for every window that ends spacing_m or more from `committed`,
  // proportionally less when nearer [reward units].
  double churn_weight = 0.0;
  double hazard_range_m = 10e3;  // Hazard falls to 1/e at this distance.
  MovementMode movement_mode = MovementMode::kHops;
  kg_base::LonLat start;  // Position of the agent at the first begin_s.
  // Clockwise from north. Edges that leave the start are charged for the turn
  // from it (SeamWeights::turn_per_rad).
  double start_heading_rad = 0.0;
  std::string start_iri;             // IRI of the ex:AgentState with start.
  std::vector<WindowRules> windows;  // Windows still to be planned, ascending.
  // IRIs of the facts read, besides start, windows and their events.
  std::vector<std::string> read_facts;
};

bool operator==(const EventRule& a, const EventRule& b);
bool operator==(const WindowRules& a, const WindowRules& b);
// Equal except for the world version and the contents of the windows' rules
// (the set of windows must be the same).
bool SameButForWindows(const SeamRules& a, const SeamRules& b);

// Rules for `agent` from the windows with index >= first_window.
SeamRules CompileSeamRules(const kg_mission::Mission& mission,
                           const kg_mission::Agent& agent, int first_window);

// Hash of the rules without the rasters they apply to and without the world
// version.
std::string SeamRulesHash(const SeamRules& rules);

// Adds the motion model to a hash; rest_mps, which most agents lack, only if it
// is set.
void HashMotion(const MotionModel& motion, kg_base::Hasher* hash);
// Adds the weights of the seam cost terms in the order of the table. Absent
// optional terms add nothing, so that hashes without them stay unchanged.
void HashWeights(const SeamWeights& weights, kg_base::Hasher* hash);

// Are edges into the window charged for the turn from the start heading? True
// for the first window, whose edges leave the start, if turns have a price.
bool ChargesTurns(const SeamRules& rules, const WindowRules& window);
// Adds the start heading if edges into the window are charged for turns. Adds
// nothing otherwise, so that hashes without it stay unchanged.
void HashStartHeading(const SeamRules& rules, const WindowRules& window,
                      kg_base::Hasher* hash);

// Adds the committed end of the window, if the current plan has one. Adds
// nothing otherwise, so that hashes without it stay unchanged.
void HashCommitted(const WindowRules& window, kg_base::Hasher* hash);

// Sorted IRIs of the facts that the rules were compiled from: agent, policy,
// capabilities, mission, start, windows and the windows' events. Reflects later
// changes of start, windows and events.
std::vector<std::string> SeamRulesSources(const SeamRules& rules);

}  // namespace kg_compiler

#endif  // KG_COMPILER_CONTROL_PLANE_SEAM_RULES_H_
