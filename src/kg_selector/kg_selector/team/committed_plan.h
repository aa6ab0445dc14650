// The plan that a selector commits for a team, with its provenance: the run and
// the facts it is based on, its bound, and stage durations.

#ifndef KG_SELECTOR_TEAM_COMMITTED_PLAN_H_
#define KG_SELECTOR_TEAM_COMMITTED_PLAN_H_

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "kg_selector/paths/pathlet.h"
#include "kg_selector/team/coordinator.h"
#include "kg_selector/team/plan_mission.h"

namespace kg_selector {

// Duration of one stage of a cycle, and the number of items it produced.
struct StageTime {
  std::string stage;     // "facts", "ingest", "compile", "plan", "select", ...
  double seconds = 0.0;  // Wall-clock.
  std::size_t count = 0;
};

// The path of one agent; the pathlet names it by its ex:id.
struct PathAssignment {
  std::string agent_iri;
  Pathlet pathlet;
};

struct CommittedPlan {
  double time_s = 0.0;  // Creation time [Unix s].
  std::uint64_t world_version = 0;
  std::uint64_t cycle = 0;
  std::uint64_t run = 0;  // Run number, ascending.
  int rounds = 0;         // Replanning rounds.
  double reward = 0.0;    // Team total, like seam_cost.
  double seam_cost = 0.0;
  // Upper bound of reward - seam_cost; not finite = none known.
  double bound = std::numeric_limits<double>::quiet_NaN();
  std::string mode;  // Team mode that made the plan.
  // Comparison with the previous plan (stability.h); NaN = unknown.
  double stability = std::numeric_limits<double>::quiet_NaN();
  double displacement_m = std::numeric_limits<double>::quiet_NaN();
  std::vector<PathAssignment> assignments;  // In order of commitment.
  // Agents without a path: reason by ex:id.
  std::map<std::string, std::string> unassigned;
  std::vector<StageTime> stages;
};

// "id: reason" of each agent without a path.
std::vector<std::string> UnassignedLines(const CommittedPlan& plan);

// A rejected pathlet.
struct RecordedRejection {
  std::string agent_iri;
  RejectedPath rejection;
};

// The plan as the selector node commits it, without time, versions, run and
// stages.
CommittedPlan ToCommittedPlan(const PlannedMission& planned);

}  // namespace kg_selector

#endif  // KG_SELECTOR_TEAM_COMMITTED_PLAN_H_
