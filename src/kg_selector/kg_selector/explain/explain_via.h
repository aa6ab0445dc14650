// The best path through any of some waypoints of a window, or why no such path
// is feasible: energy, paths committed earlier, or no way onward.

#ifndef KG_SELECTOR_EXPLAIN_EXPLAIN_VIA_H_
#define KG_SELECTOR_EXPLAIN_EXPLAIN_VIA_H_

#include <cstddef>
#include <set>
#include <string>

#include "kg_compiler/explain/explanation.h"
#include "kg_selector/explain/planned_world.h"

namespace kg_selector {

struct ViaWaypoints {
  std::size_t stage = 0;
  std::set<int> waypoints;  // Passed through or ended at (any one of them).
  std::string name;         // Display text: "waypoint 3 of window 2".
};

// The agent must have a path. Verdicts: worth_less, energy, conflict and
// dead_end (why_not.h).
kg_compiler::Explanation ExplainPathVia(const PlannedWorld& world,
                                        const kg_mission::Agent& agent,
                                        const ViaWaypoints& by);

// Verdict "taken": the path does pass there.
kg_compiler::Explanation ExplainTaken(const PlannedWorld& world,
                                      const kg_mission::Agent& agent,
                                      const Visit& visit,
                                      const std::string& name);

}  // namespace kg_selector

#endif  // KG_SELECTOR_EXPLAIN_EXPLAIN_VIA_H_
