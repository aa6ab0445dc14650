// Why a path does not visit a place: the first of these verdicts that holds,
// with its margin.
//
//   taken        the path does go there: see the assignment
//   forbidden, unreachable, unholdable, unflyable   (explain_place.h)
//   not_sampled  the place is no waypoint: its response minus that of the
//   waypoint
//                of least score, or a waypoint lies within the spacing
//   expired, not_active   of an event: seconds between it and the window
//   capacity     of an event: capacity minus the agents that use it
//   energy       energy the cheapest path through it lacks [J]
//   conflict     separation missing on the best path through it [m]
//   dead_end     no edge leads onward from it
//   worth_less   score of the path chosen - best score through it

#ifndef KG_SELECTOR_EXPLAIN_WHY_NOT_H_
#define KG_SELECTOR_EXPLAIN_WHY_NOT_H_

#include <string>

#include "kg_base/geo/lon_lat.h"
#include "kg_compiler/explain/explanation.h"
#include "kg_selector/explain/planned_world.h"

namespace kg_selector {

struct WaypointName {
  int window = 0;
  int id = 0;
};

// All throw kg_base::InputError for unknown agents, windows or targets.
kg_compiler::Explanation WhyNotWaypoint(const PlannedWorld& world,
                                        const kg_mission::Agent& agent,
                                        const WaypointName& waypoint);
// `window` -1: the best of the planned windows in which the event is open.
kg_compiler::Explanation WhyNotEvent(const PlannedWorld& world,
                                     const kg_mission::Agent& agent,
                                     const std::string& event, int window);
kg_compiler::Explanation WhyNotPlace(const PlannedWorld& world,
                                     const kg_mission::Agent& agent,
                                     kg_base::LonLat place, int window);

// Finds an event by IRI or "ex:seep"; null = unknown.
const kg_mission::Event* FindEvent(const PlannedWorld& world,
                                   const std::string& name);

}  // namespace kg_selector

#endif  // KG_SELECTOR_EXPLAIN_WHY_NOT_H_
