// One straight leg in a current: the integration that every search and every
// flight of this package goes through (traversal.h has the equations).

#ifndef KG_COMPILER_TRAVERSAL_LEG_H_
#define KG_COMPILER_TRAVERSAL_LEG_H_

#include <optional>

#include "kg_compiler/data_plane/cell_box.h"
#include "kg_compiler/traversal/voyage.h"

namespace kg_compiler {

// How carefully to fly. `slack`: the share of V that must be left, of the
// heading and of the way made good, so that what lies between two samples of
// the current cannot undo the leg.
struct LegCare {
  double step_cells;
  double slack;
};
inline constexpr LegCare kFlight = {0.1, 0.002};

struct TrackLeg {
  kg_base::LonLat from;
  kg_base::LonLat to;
  double depart_s = 0.0;  // After the departure's time.
};

struct LegEnd {
  double arrive_s = 0.0;  // After the departure's time.
  double hazard_s = 0.0;
};

// When one must be there [s after the departure's time]: by the deadline, and
// before the base travel is used up.
double LatestArrival_s(const MotionModel& motion,
                       const VoyageDeparture& departure);

// Flies legs of one departure.
class LegFlyer {
 public:
  // The voyage must outlive it. What lies outside of `box`, if any is given,
  // counts as closed.
  explicit LegFlyer(const VoyageRequest& voyage, const CellBox* box = nullptr);

  std::optional<LegEnd> Fly(const TrackLeg& leg, const LegCare& care) const;

  // c = boost_gain current; nothing where unknown. Time after the departure's.
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
  double latest_s_;  // After the departure's time.
};

}  // namespace kg_compiler

#endif  // KG_COMPILER_TRAVERSAL_LEG_H_
