// Why a path does not go somewhere: the first of these that holds, with its
// margin.
//
//   taken        it does go there: see the assignment
//   forbidden, unreachable, unholdable, unflyable   (explain_place.h)
//   not_sampled  the place is no waypoint: its response against the waypoint's
//                of least score, or a waypoint is nearer than the spacing
//   expired, not_active   of an event: seconds between it and the window
//   capacity     of an event: places less the agents that have it
//   energy       joules that the thriftiest path by way of it lacks
//   conflict     metres that the best path by way of it comes too close
//   dead_end     no way leads on from it
//   worth_less   score of the path chosen less the best score by way of it

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

// All throw kg_base::InputError for what is not there.
kg_compiler::Explanation WhyNotWaypoint(const PlannedWorld& world,
                                        const kg_mission::Agent& agent,
                                        const WaypointName& waypoint);
// `window` -1: the best of those planned in which the event is open.
kg_compiler::Explanation WhyNotEvent(const PlannedWorld& world,
                                     const kg_mission::Agent& agent,
                                     const std::string& event, int window);
kg_compiler::Explanation WhyNotPlace(const PlannedWorld& world,
                                     const kg_mission::Agent& agent,
                                     kg_base::LonLat place, int window);

// By IRI or "ex:seep"; null = unknown.
const kg_mission::Event* FindEvent(const PlannedWorld& world,
                                   const std::string& name);

}  // namespace kg_selector

#endif  // KG_SELECTOR_EXPLAIN_WHY_NOT_H_
