// The plan that a selector commits for a team, with what is recorded beside it:
// which run made it, for which facts, how good it is, how long it took.

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

// How long one stage of a cycle took, and how many things it made.
struct StageTime {
  std::string stage;     // "facts", "ingest", "compile", "plan", "select", ...
  double seconds = 0.0;  // Wall-clock.
  std::size_t count = 0;
};

// What one agent is to do; the pathlet names it by its ex:id.
struct PathAssignment {
  std::string agent_iri;
  Pathlet pathlet;
};

struct CommittedPlan {
  double time_s = 0.0;  // When it was made, Unix seconds.
  std::uint64_t world_version = 0;
  std::uint64_t cycle = 0;
  std::uint64_t run = 0;  // Number of the run, counts up.
  int rounds = 0;         // Of planning again around each other.
  double reward = 0.0;    // Of the team, as is seam_cost.
  double seam_cost = 0.0;
  // Upper bound of reward - seam_cost; not finite = none known.
  double bound = std::numeric_limits<double>::quiet_NaN();
  std::string mode;  // By which it was chosen.
  // Compared with the plan before (stability.h); NaN = not known.
  double stability = std::numeric_limits<double>::quiet_NaN();
  double displacement_m = std::numeric_limits<double>::quiet_NaN();
  std::vector<PathAssignment> assignments;  // In order of commitment.
  // Why agents have no path, by ex:id.
  std::map<std::string, std::string> unassigned;
  std::vector<StageTime> stages;
};

// "id: reason" of each agent without a path.
std::vector<std::string> UnassignedLines(const CommittedPlan& plan);

// A pathlet that lost.
struct RecordedRejection {
  std::string agent_iri;
  RejectedPath rejection;
};

// The plan as the selector node commits it, but for time, versions, run and
// stages.
CommittedPlan ToCommittedPlan(const PlannedMission& planned);

}  // namespace kg_selector

#endif  // KG_SELECTOR_TEAM_COMMITTED_PLAN_H_
