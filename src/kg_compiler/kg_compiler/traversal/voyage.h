// Input of a traversal (world, motion model, departure, prices) and its result
// (a flight). Values only; traversal.h has the equations.
// Times are Unix seconds unless said otherwise, lengths metres, energy joules.

#ifndef KG_COMPILER_TRAVERSAL_VOYAGE_H_
#define KG_COMPILER_TRAVERSAL_VOYAGE_H_

#include <limits>
#include <vector>

#include "kg_base/geo/lon_lat.h"
#include "kg_base/raster/grid.h"
#include "kg_base/raster/vector_field.h"
#include "kg_compiler/traversal/hazard_map.h"
#include "kg_compiler/traversal/motion.h"

namespace kg_compiler {

struct TimedPoint {
  kg_base::LonLat position;
  double time_s = 0.0;  // Unix seconds.
};

// A flown path: from the departure through its turning points to the arrival,
// then at rest there until the deadline.
struct FlownPath {
  std::vector<TimedPoint> track;  // Ends with arrival and, if later, deadline.
  double travel_s = 0.0;          // Departure to arrival.
  double energy_j = 0.0;          // Propulsion, hotel load and holding station.
  double hazard_s = 0.0;  // Hazard in [0, 1] integrated until the deadline.
  double through_water_m = 0.0;
  double speed_mps = 0.0;  // Through water until the arrival.
};

// The world for the traversal of one window. All members share one grid.
struct TraversalWorld {
  const kg_base::VectorField* field = nullptr;
  const kg_base::Mask* open = nullptr;  // 1 = may be entered.
  const HazardMap* hazard = nullptr;    // Null = no hazard.
};

struct VoyageDeparture {
  kg_base::LonLat from;
  double time_s = 0.0;  // Unix seconds, as is deadline_s.
  double deadline_s = 0.0;
  // Limit of the distance through water until the arrival (A17); holding
  // station does not count.
  double base_travel_m = std::numeric_limits<double>::infinity();
};

// Weights of the flight's cost: per second under way, per joule, and per second
// at hazard 1. All 0 or only per_s set: the fastest flight.
struct FlightPrice {
  double per_s = 0.0;
  double per_j = 0.0;
  double per_hazard_s = 0.0;
};

// Complete input of one traversal.
struct VoyageRequest {
  TraversalWorld world;
  MotionModel motion;
  VoyageDeparture departure;
  FlightPrice price;
};

// Whether a request makes sense; anything else reaches nothing and is not
// flown. A field with slices, all of them and `open` of the size of the grid; a
// finite departure at most 100 years before its deadline; finite figures of the
// motion, the speed not negative; prices and limits may be infinite, not NaN.
bool IsWellFormed(const VoyageRequest& voyage);

}  // namespace kg_compiler

#endif  // KG_COMPILER_TRAVERSAL_VOYAGE_H_
