// Getting from one place to others in time-varying currents within a deadline.
//
// Velocity over ground = water velocity (speed V, free heading) + boost_gain *
// current(x, t): Zermelo's navigation problem [1], solved by extremals. A fan
// of them (fan.h) gives the earliest arrivals, shooting (shooting.h) the track
// to a place, also where the current is stronger than the agent.
//
// What counts is the flight: FlyTrack() integrates a track with sub-cell steps,
// crabbing into the cross current, and every figure of a FlownPath comes from
// it. Then station is held until the deadline (|current| <= max_mps, else
// refused):
//
//   c = boost_gain current, split along and across the leg
//   ground speed  ds/dt = c_along + sqrt(V^2 - c_across^2)
//   energy = energy_per_m (V travel_s + int |c| dt at rest) + hotel (whole
//   time) hazard = int hazard(x(t)) dt
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

// The flight from the departure to `to` with the least
//   per_s travel_s + per_j energy_j + per_hazard_s hazard_s,
// or nothing if none was found that can be flown. `reach` is ComputeReach of
// the same voyage. The fastest, and never slower than straight there, unless
// energy has a price: then slower speeds are tried, too (the shares of
// SlowerReaches, and if one is cheaper, those around it to about 0.3 % of
// cruise_mps), where a lower bound of their cost leaves 0.1 % to gain, each on
// its fastest track (arriving later than one could at that speed is not tried).
//
// The track is the extremal, simplified: linear interpolation in time between
// its points stays within 0.05 cells of where the extremal is; what is flown
// and claimed is the simplified track.
std::optional<FlownPath> Traverse(const VoyageRequest& voyage,
                                  const ReachMap& reach, kg_base::LonLat to);

}  // namespace kg_compiler

#endif  // KG_COMPILER_TRAVERSAL_TRAVERSAL_H_
