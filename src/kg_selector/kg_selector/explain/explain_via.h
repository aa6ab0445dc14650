// The best path by way of some waypoints of a window, or what keeps every such
// path from being flown: energy, those committed before, or that no way leads
// on.

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
  std::set<int> waypoints;  // Any of them, as a stop or where it ends.
  std::string name;         // For a person: "waypoint 3 of window 2".
};

// The agent must have a path. The verdicts worth_less, energy, conflict and
// dead_end (why_not.h).
kg_compiler::Explanation ExplainPathVia(const PlannedWorld& world,
                                        const kg_mission::Agent& agent,
                                        const ViaWaypoints& by);

// The verdict taken: it does go there.
kg_compiler::Explanation ExplainTaken(const PlannedWorld& world,
                                      const kg_mission::Agent& agent,
                                      const Visit& visit,
                                      const std::string& name);

}  // namespace kg_selector

#endif  // KG_SELECTOR_EXPLAIN_EXPLAIN_VIA_H_
