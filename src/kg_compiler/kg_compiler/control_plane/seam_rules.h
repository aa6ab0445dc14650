// The control plane's rules for one agent, compiled from facts: what it can do,
// what that costs, and what a visit is worth. Plain numbers, SI; sent to the
// agent's planner, which applies them with nav_graph.h.

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

// A discrete point of interest, for one window.
struct EventRule {
  std::string iri;
  kg_base::LonLat position;
  double reward = 0.0;    // Of one visit in this window (value times w_t).
  double radius_m = 0.0;  // A waypoint within it visits the event.
};

struct WindowRules {
  int window = 0;
  std::string iri;
  double begin_s = 0.0;  // Unix seconds.
  double end_s = 0.0;
  double confidence = 1.0;
  double base_travel_m = 0.0;  // Through water in one window (A17).
  std::vector<EventRule> events;
  std::string tensor_hash;  // The inputs these rules go with.
  std::string field_hash;
  // Where the plan in force says that this window ends, if the policy minds.
  std::optional<kg_base::LonLat> committed = std::nullopt;
};

struct SeamRules {
  std::string agent_iri;
  std::string agent_id;
  std::uint64_t world_version = 0;
  MotionModel motion;
  SeamWeights weights;
  double energy_budget_j = 0.0;  // What is left for all windows below.
  // Of hazard_s + isolation_s over all windows below.
  double hazard_budget_s = std::numeric_limits<double>::infinity();
  double sensor_radius_m = 0.0;  // Footprint of a visit: PR's disc.
  double spacing_m = 0.0;        // Least distance between waypoints.
  int max_waypoints = 20;        // Per window.
  int candidates = 10;           // K.
  bool diverse = false;          // K paths that differ, not the K best.
  int minimum_difference = 1;    // Windows in which two of them do.
  // Taken off for every window that ends spacing_m or more from `committed`;
  // in proportion nearer. In reward units.
  double churn_weight = 0.0;
  double hazard_range_m = 10e3;  // Hazard falls to 1/e at this distance.
  MovementMode movement_mode = MovementMode::kHops;
  kg_base::LonLat start;             // Where the agent is at the first begin_s.
  double start_heading_rad = 0.0;    // Clockwise from north.
  std::string start_iri;             // The ex:AgentState that says so.
  std::vector<WindowRules> windows;  // Those still to be planned, ascending.
  // The facts that were read beside the start, the windows and their events.
  std::vector<std::string> read_facts;
};

bool operator==(const EventRule& a, const EventRule& b);
bool operator==(const WindowRules& a, const WindowRules& b);
// Equal but for the world version and the windows' rules (the windows there are
// count, what they say does not).
bool SameButForWindows(const SeamRules& a, const SeamRules& b);

// Rules for `agent` from the windows with index >= first_window.
SeamRules CompileSeamRules(const kg_mission::Mission& mission,
                           const kg_mission::Agent& agent, int first_window);

// Of all that the rules say: not of the rasters they go with, nor of the world
// version.
std::string SeamRulesHash(const SeamRules& rules);

// Adds how the agent moves; what most do not have (rest_mps), only if it is
// there.
void HashMotion(const MotionModel& motion, kg_base::Hasher* hash);
// Adds what the seam cost terms weigh, in the order of the table and nothing
// for what is optional and absent: so that without it a hash is what it was.
void HashWeights(const SeamWeights& weights, kg_base::Hasher* hash);

// Adds where the window is to end, if the plan in force says so: nothing else,
// so that without it a hash is what it was.
void HashCommitted(const WindowRules& window, kg_base::Hasher* hash);

// The IRIs of the facts they were compiled from, sorted: agent, policy,
// capabilities, mission, start, windows and the windows' events. Follows
// changes of start, windows and events.
std::vector<std::string> SeamRulesSources(const SeamRules& rules);

}  // namespace kg_compiler

#endif  // KG_COMPILER_CONTROL_PLANE_SEAM_RULES_H_
