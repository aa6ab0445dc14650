// Flying a given track, and holding station at its end (traversal.h has the
// equations). Every figure of a FlownPath comes from this integration.

#ifndef KG_COMPILER_TRAVERSAL_FLIGHT_H_
#define KG_COMPILER_TRAVERSAL_FLIGHT_H_

#include <optional>
#include <vector>

#include "kg_base/geo/lon_lat.h"
#include "kg_compiler/data_plane/cell_box.h"
#include "kg_compiler/traversal/voyage.h"

namespace kg_compiler {

// Earliest time from which station can be held at a place until the deadline,
// i.e. |boost_gain * current| <= max_mps throughout. Infinite if it cannot be
// held at the deadline itself, where the current is unknown, or if the voyage
// is not well-formed.
double HoldableFrom_s(const VoyageRequest& voyage, kg_base::LonLat place);

// Flies along `via` (first = departure, legs straight in longitude and
// latitude), holding V = cruise_mps through water on every leg. Nothing if a
// leg cannot be held in the current, leaves the grid or the open cells (every
// cell the leg touches counts, both beside a corner it passes), the deadline
// passes, or station cannot be held then. A leg can be held where 99.8 % of V
// compensate the cross current and at least 0.2 % of V are left over ground,
// sampled every 0.05 cells. Cells outside `box`, if given, count as closed.
std::optional<FlownPath> FlyTrack(const VoyageRequest& voyage,
                                  const std::vector<kg_base::LonLat>& via,
                                  const CellBox* box = nullptr);

// A part of a track flown at one speed through water. Its first place is the
// end of the previous stretch, or the departure.
struct TrackStretch {
  std::vector<kg_base::LonLat> via;
  double speed_mps = 0.0;
};

// Flies the stretches in sequence, each as FlyTrack does, starting when the
// previous one has arrived. Nothing for a speed that is negative, infinite or
// NaN. Station is held at the end of the last only; the
// base travel limit applies to their sum. speed_mps of the flight is the mean
// until the arrival.
std::optional<FlownPath> FlyStretches(
    const VoyageRequest& voyage, const std::vector<TrackStretch>& stretches);

}  // namespace kg_compiler

#endif  // KG_COMPILER_TRAVERSAL_FLIGHT_H_
