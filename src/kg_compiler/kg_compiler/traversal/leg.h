// One straight leg in a current: the integration that every search and every
// flight of this package goes through (traversal.h has the equations).

#ifndef KG_COMPILER_TRAVERSAL_LEG_H_
#define KG_COMPILER_TRAVERSAL_LEG_H_

#include <optional>

#include "kg_compiler/data_plane/cell_box.h"
#include "kg_compiler/traversal/voyage.h"

namespace kg_compiler {

// Step size and safety margin of the integration. `slack`: fraction of V that
// must remain both in the cross-current correction and in the ground speed, so
// that the current between two samples cannot make the leg infeasible.
struct LegCare {
  double step_cells;
  double slack;
};
inline constexpr LegCare kFlight = {0.1, 0.002};

struct TrackLeg {
  kg_base::LonLat from;
  kg_base::LonLat to;
  double depart_s = 0.0;  // Seconds after the departure.
};

struct LegEnd {
  double arrive_s = 0.0;  // Seconds after the departure.
  double hazard_s = 0.0;
};

// Latest arrival [s after the departure]: the deadline, or the time at which
// the base travel is used up, whichever is earlier.
double LatestArrival_s(const MotionModel& motion,
                       const VoyageDeparture& departure);

// Flies legs of one departure.
class LegFlyer {
 public:
  // The voyage must outlive this object. Cells outside the grid, and outside
  // `box` if given, count as closed.
  explicit LegFlyer(const VoyageRequest& voyage, const CellBox* box = nullptr);

  std::optional<LegEnd> Fly(const TrackLeg& leg, const LegCare& care) const;

  // c = boost_gain current, at `time_s` after the departure; nullopt where
  // unknown.
  std::optional<kg_base::Velocity> Current(kg_base::GridPoint at,
                                           double time_s) const;
  bool IsOpen(kg_base::Cell cell) const;
  double HazardAt(kg_base::Cell cell) const;
  kg_base::Cell CellOf(kg_base::GridPoint at) const;
  const kg_base::Grid& grid() const { return world_.field->grid; }

 private:
  const TraversalWorld& world_;
  const MotionModel& motion_;
  CellBox box_;
  double epoch_s_;
  double latest_s_;  // Latest arrival [s after the departure].
};

}  // namespace kg_compiler

#endif  // KG_COMPILER_TRAVERSAL_LEG_H_
