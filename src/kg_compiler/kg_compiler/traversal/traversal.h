// Fastest and cheapest flights in time-varying currents within a deadline.
//
// Velocity over ground = water velocity (speed V, free heading) + boost_gain *
// current(x, t): Zermelo's navigation problem [1], solved by extremals. A fan
// of them (fan.h) gives the earliest arrivals, shooting (shooting.h) the track
// to a place, also where the current is stronger than the agent.
//
// All reported figures come from the flight: FlyTrack() integrates a track with
// sub-cell steps, crabbing into the cross current. Then station is held until
// the deadline (|current| <= max_mps, otherwise the flight is rejected):
//
//   c = boost_gain current, split along and across the leg
//   ground speed  ds/dt = c_along + sqrt(V^2 - c_across^2)
//   energy = energy_per_m (V travel_s + int |c| dt at rest)
//            + hotel_load_w (deadline - departure)
//   hazard = int hazard(x(t)) dt
//
// [1] E. Zermelo, ZAMM 11(2), 1931, pp. 114-124.

#ifndef KG_COMPILER_TRAVERSAL_TRAVERSAL_H_
#define KG_COMPILER_TRAVERSAL_TRAVERSAL_H_

#include <optional>

#include "kg_base/geo/lon_lat.h"
#include "kg_compiler/traversal/compute_reach.h"
#include "kg_compiler/traversal/flight.h"
#include "kg_compiler/traversal/reach.h"
#include "kg_compiler/traversal/voyage.h"

namespace kg_compiler {

// The flight from the departure to `to` that minimises
//   per_s travel_s + per_j energy_j + per_hazard_s hazard_s,
// or nullopt if no feasible one was found or the voyage is not well-formed.
// `reach` is ComputeReach of the same voyage. Without a price of energy this is
// the fastest flight found, never slower than the straight leg. With one,
// slower speeds are tried as well: the fractions of SlowerReaches and, if one
// of them is cheaper, those around it to about 0.3 % of cruise_mps. A speed is
// skipped if a lower bound of its cost leaves less than 0.1 % to gain. Each
// speed is tried on its fastest track only (arriving later than possible at
// that speed is not tried).
//
// The track is the simplified extremal: linear interpolation in time between
// its points stays within 0.05 cells of the extremal. All figures of the result
// are those of the simplified track.
std::optional<FlownPath> Traverse(const VoyageRequest& voyage,
                                  const ReachMap& reach, kg_base::LonLat to);

}  // namespace kg_compiler

#endif  // KG_COMPILER_TRAVERSAL_TRAVERSAL_H_
