#include "kg_compiler/traversal/flight.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "kg_compiler/traversal/leg.h"

namespace kg_compiler {
namespace {

constexpr double kHoldCheck_s = 600.0;
constexpr double kNotFlown = std::numeric_limits<double>::infinity();

double Speed(const kg_base::Velocity& c) {
  return std::hypot(c.east_mps, c.north_mps);
}

// Slice times between two times [s after the departure], plus both ends:
// between knots the current at a place is linear in time.
std::vector<double> Knots(const kg_base::VectorField& field, double epoch_s,
                          double begin_s, double end_s) {
  std::vector<double> knots(1, begin_s);
  for (const kg_base::FieldSlice& slice : field.slices) {
    const double time_s = slice.time_s - epoch_s;
    if (time_s > begin_s && time_s < end_s) knots.push_back(time_s);
  }
  knots.push_back(end_s);
  return knots;
}

// Distance through water [m] needed to hold station over the knots; nullopt if
// the current is unknown or above max_mps.
std::optional<double> Hold_m(const LegFlyer& flyer, const MotionModel& motion,
                             kg_base::GridPoint at,
                             const std::vector<double>& knots) {
  double through_m = 0.0;
  for (std::size_t k = 0; k + 1 < knots.size(); ++k) {
    const double span_s = knots[k + 1] - knots[k];
    const int steps =
        std::max(1, static_cast<int>(std::ceil(span_s / kHoldCheck_s)));
    // Trapezoidal rule over the speed needed to stay: that of the current, or
    // rest_mps if larger.
    double before_mps = kNotFlown;
    for (int i = 0; i <= steps; ++i) {
      const auto c = flyer.Current(at, knots[k] + span_s * i / steps);
      if (!c || !(Speed(*c) <= motion.max_mps)) return std::nullopt;
      const double held_mps = std::max(Speed(*c), motion.rest_mps);
      if (i > 0) through_m += 0.5 * (before_mps + held_mps) * span_s / steps;
      before_mps = held_mps;
    }
  }
  return through_m;
}

// Parameter in [0, 1] from c to d, |c| > limit >= |d|, at which the speed drops
// to the limit.
double CrossingShare(const kg_base::Velocity& c, const kg_base::Velocity& d,
                     double limit_mps) {
  const Eigen::Vector2d from(c.east_mps, c.north_mps);
  const Eigen::Vector2d change =
      Eigen::Vector2d(d.east_mps, d.north_mps) - from;
  // |from + s change| = limit is a quadratic equation in s; the smaller root.
  const double square = change.squaredNorm();
  const double half = from.dot(change);
  const double rest = Speed(c) * Speed(c) - limit_mps * limit_mps;
  const double root = std::sqrt(std::max(0.0, half * half - square * rest));
  return std::clamp((-half - root) / square, 0.0, 1.0);
}

void CheckStretches(const VoyageDeparture& departure,
                    const std::vector<TrackStretch>& stretches) {
  if (stretches.empty()) throw std::logic_error("a flight has a stretch");
  kg_base::LonLat at = departure.from;
  for (const TrackStretch& stretch : stretches) {
    if (stretch.via.empty() || stretch.via.front() != at) {
      throw std::logic_error("a track begins at its departure");
    }
    at = stretch.via.back();
  }
}

// The voyage at a stretch's speed after `through_m` of travel in `spent_s`: the
// same departure, with the base travel adjusted so that the latest arrival
// accounts for the distance already used.
VoyageRequest OnStretch(VoyageRequest voyage, const TrackStretch& stretch,
                        double through_m, double spent_s) {
  voyage.motion.cruise_mps = stretch.speed_mps;
  voyage.departure.base_travel_m += stretch.speed_mps * spent_s - through_m;
  return voyage;
}

// Appends one stretch to a flight, without holding station.
bool FlyStretch(const LegFlyer& flyer, const TrackStretch& stretch,
                double begin_s, FlownPath* flight) {
  for (std::size_t i = 0; i < stretch.via.size(); ++i) {
    const TrackLeg leg{stretch.via[i == 0 ? 0 : i - 1], stretch.via[i],
                       flight->travel_s};
    const std::optional<LegEnd> end = flyer.Fly(leg, kFlight);
    if (!end) return false;
    flight->travel_s = end->arrive_s;
    flight->hazard_s += end->hazard_s;
    if (leg.from == leg.to) continue;
    flight->track.push_back({stretch.via[i], begin_s + flight->travel_s});
  }
  return true;
}

// Adds holding station at the end of the flight until the deadline.
bool HoldStation(const VoyageRequest& voyage, const LegFlyer& flyer,
                 FlownPath* flight) {
  const MotionModel& motion = voyage.motion;
  const VoyageDeparture& departure = voyage.departure;
  const double whole_s = departure.deadline_s - departure.time_s;
  const kg_base::LonLat place = flight->track.back().position;
  const kg_base::GridPoint at = *flyer.grid().Locate(place);
  const std::optional<double> held_m = Hold_m(
      flyer, motion, at,
      Knots(*voyage.world.field, departure.time_s, flight->travel_s, whole_s));
  if (!held_m) return false;
  const double rest_s = whole_s - flight->travel_s;
  flight->hazard_s += rest_s * flyer.HazardAt(flyer.CellOf(at));
  flight->through_water_m += *held_m;
  flight->energy_j = motion.energy_per_m_j * flight->through_water_m +
                     motion.hotel_load_w * whole_s;
  if (rest_s > 0.0) flight->track.push_back({place, departure.deadline_s});
  return true;
}

// Is every number of the flight one that can be flown?
bool IsWellFormed(const VoyageRequest& voyage,
                  const std::vector<TrackStretch>& stretches) {
  for (const TrackStretch& stretch : stretches) {
    if (!(stretch.speed_mps >= 0.0) || !std::isfinite(stretch.speed_mps)) {
      return false;
    }
  }
  return kg_compiler::IsWellFormed(voyage);
}

std::optional<FlownPath> FlyAll(const VoyageRequest& voyage,
                                const std::vector<TrackStretch>& stretches,
                                const CellBox* box) {
  if (!IsWellFormed(voyage, stretches)) return std::nullopt;
  CheckStretches(voyage.departure, stretches);
  const double begin_s = voyage.departure.time_s;
  FlownPath flight;
  flight.speed_mps = stretches.front().speed_mps;
  flight.track.push_back({voyage.departure.from, begin_s});
  // Each stretch at its speed, with the base travel left by the previous ones.
  for (const TrackStretch& stretch : stretches) {
    const double before_s = flight.travel_s;
    const VoyageRequest piece =
        OnStretch(voyage, stretch, flight.through_water_m, before_s);
    if (!FlyStretch(LegFlyer(piece, box), stretch, begin_s, &flight)) {
      return std::nullopt;
    }
    flight.through_water_m += stretch.speed_mps * (flight.travel_s - before_s);
  }
  // Mean speed for several stretches; a single one keeps its speed bit for bit.
  if (stretches.size() > 1 && flight.travel_s > 0.0) {
    flight.speed_mps = flight.through_water_m / flight.travel_s;
  }
  if (!HoldStation(voyage, LegFlyer(voyage, box), &flight)) return std::nullopt;
  return flight;
}

}  // namespace

double HoldableFrom_s(const VoyageRequest& voyage, kg_base::LonLat place) {
  const MotionModel& motion = voyage.motion;
  const VoyageDeparture& departure = voyage.departure;
  if (!IsWellFormed(voyage)) return kNotFlown;
  const LegFlyer flyer(voyage);
  const std::optional<kg_base::GridPoint> at = flyer.grid().Locate(place);
  if (!at) return kNotFlown;
  const std::vector<double> knots =
      Knots(*voyage.world.field, departure.time_s, 0.0,
            departure.deadline_s - departure.time_s);
  // Backwards from the deadline: find the last knot with too strong a current,
  // then the time after it at which the speed drops to max_mps.
  std::optional<kg_base::Velocity> later;
  for (std::size_t k = knots.size(); k-- > 0;) {
    const auto c = flyer.Current(*at, knots[k]);
    if (!c) return kNotFlown;
    if (!(Speed(*c) <= motion.max_mps)) {
      if (!later) return kNotFlown;
      const double share = CrossingShare(*c, *later, motion.max_mps);
      return departure.time_s + knots[k] + share * (knots[k + 1] - knots[k]);
    }
    later = c;
  }
  return departure.time_s;
}

std::optional<FlownPath> FlyTrack(const VoyageRequest& voyage,
                                  const std::vector<kg_base::LonLat>& via,
                                  const CellBox* box) {
  return FlyAll(voyage, {{via, voyage.motion.cruise_mps}}, box);
}

std::optional<FlownPath> FlyStretches(
    const VoyageRequest& voyage, const std::vector<TrackStretch>& stretches) {
  return FlyAll(voyage, stretches, nullptr);
}

}  // namespace kg_compiler
