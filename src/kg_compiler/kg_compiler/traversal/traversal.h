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

#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "kg_compiler/data_plane/cell_box.h"
#include "kg_compiler/traversal/hazard_map.h"
#include "kg_compiler/traversal/motion.h"
#include "kg_core/geo/lon_lat.h"
#include "kg_core/raster/grid.h"
#include "kg_core/raster/vector_field.h"

namespace kg_compiler {

struct TimedPoint {
  kg_core::LonLat position;
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

// The world as one window's traversal sees it. All on one grid.
struct TraversalWorld {
  const kg_core::VectorField* field = nullptr;
  const kg_core::Mask* open = nullptr;  // 1 = may be entered.
  const HazardMap* hazard = nullptr;    // Null = no hazard.
};

struct VoyageDeparture {
  kg_core::LonLat from;
  double time_s = 0.0;  // Unix seconds, as the deadline.
  double deadline_s = 0.0;
  // Most that may be travelled through water to get there (A17); holding
  // station does not count.
  double base_travel_m = std::numeric_limits<double>::infinity();
};

// What a flight is chosen by: the price of a second under way, of a joule, and
// of a second at hazard 1. All 0 or only per_s set: the fastest.
struct FlightPrice {
  double per_s = 0.0;
  double per_j = 0.0;
  double per_hazard_s = 0.0;
};

// Who sets out from where, into what world.
struct VoyageRequest {
  TraversalWorld world;
  MotionModel motion;
  VoyageDeparture departure;
  FlightPrice price;
};

// A cell one can be at, with the earliest arrival found.
struct ReachedCell {
  double arrival_s = 0.0;    // At its centre, seconds after departure.
  int index = 0;             // Of the grid.
  int root = 0;              // Where the extremal that comes first set out.
  float heading_rad = 0.0f;  // Through water then, counter-clockwise from east,
  float spread_rad = 0.0f;   // between extremals so far apart.
};

// Where extremals set out: the departure, and the corners of what is closed,
// which tracks go round.
struct ReachRoot {
  kg_core::GridPoint place;
  double time_s = 0.0;  // After the departure.
  int parent = -1;      // The root from which it is reached; -1 = departure.
  double heading_rad = 0.0;  // With which one leaves the parent to get there,
  double spread_rad = 0.0;   // between extremals so far apart.
};

class SlowerReaches;

struct ReachMap {
  std::vector<ReachedCell> cells;  // By index.
  std::vector<ReachRoot> roots;    // The departure first.
  double cells_per_s = 0.0;        // The fastest met.
  // Neither this reach nor any flight that Traverse finds by it reads the
  // world's `open` or field outside of it. (Hazard at a cell in it depends on
  // what is open within HazardMap::kRanges ranges.)
  CellBox read;
  // At slower speeds, made when first needed; null if energy has no price.
  std::shared_ptr<SlowerReaches> slower;

  const ReachedCell* Find(int index) const;  // Null = not reached.
};

// Where one can be before the deadline at full speed. Empty if the departure
// itself is not in an open cell.
ReachMap ComputeReach(const VoyageRequest& voyage);

// Earliest time from which station can be held at a place until the deadline:
// |boost_gain * current| <= max_mps all along. Infinite if not even then, or
// where the current is unknown.
double HoldableFrom_s(const VoyageRequest& voyage, kg_core::LonLat place);

// Flies along `via` (first = departure, legs straight in longitude and
// latitude), holding V = cruise_mps through water on every leg. Nothing if a
// leg cannot be held in the current, leaves the open cells (every cell the leg
// touches counts, both beside a corner it passes), the deadline passes, or
// station cannot be held then. A leg is held where 99.8 % of V make up for the
// cross current and at least 0.2 % of V are left over ground, looked at every
// 0.05 cells.
std::optional<FlownPath> FlyTrack(const VoyageRequest& voyage,
                                  const std::vector<kg_core::LonLat>& via);

// A stretch of a way at one speed through water. Its first place is where the
// one before ended, or the departure.
struct TrackStretch {
  std::vector<kg_core::LonLat> via;
  double speed_mps = 0.0;
};

// Stretches one after the other, each flown as FlyTrack does from when the one
// before has arrived. Station is held at the end of the last only; base travel
// is what all of them take together. speed_mps of the flight is the mean until
// the arrival.
std::optional<FlownPath> FlyStretches(
    const VoyageRequest& voyage, const std::vector<TrackStretch>& stretches);

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
                                  const ReachMap& reach, kg_core::LonLat to);

}  // namespace kg_compiler

#endif  // KG_COMPILER_TRAVERSAL_TRAVERSAL_H_
