// Why a place is not a waypoint of an agent in a window: it is excluded
// (explain_place.h), or it was not sampled.

#ifndef KG_SELECTOR_EXPLAIN_WHY_NOT_PLACE_H_
#define KG_SELECTOR_EXPLAIN_WHY_NOT_PLACE_H_

#include <cstddef>

#include "kg_base/geo/lon_lat.h"
#include "kg_compiler/explain/explanation.h"
#include "kg_selector/explain/planned_world.h"

namespace kg_selector {

// Precondition: no waypoint of the stage lies there.
kg_compiler::Explanation NoWaypointThere(const PlannedWorld& world,
                                         const kg_mission::Agent& agent,
                                         kg_base::LonLat place,
                                         std::size_t stage);

}  // namespace kg_selector

#endif  // KG_SELECTOR_EXPLAIN_WHY_NOT_PLACE_H_
