#include "kg_selector/paths/pathlet.h"

#include <algorithm>
#include <cmath>

#include "kg_base/common/units.h"
#include "kg_base/geo/geodesy.h"

namespace kg_selector {
namespace {

using kg_base::LonLat;
using kg_compiler::TimedPoint;
using Track = std::vector<TimedPoint>;

// Wraps to [-180, 180]; std::remainder is slow and rarely needed.
double Wrapped(double eastward_deg) {
  return eastward_deg >= -180.0 && eastward_deg <= 180.0
             ? eastward_deg
             : std::remainder(eastward_deg, 360.0);
}

LonLat Between(LonLat a, LonLat b, double share) {
  const double eastward_deg = Wrapped(b.lon_deg - a.lon_deg);
  return {a.lon_deg + share * eastward_deg,
          a.lat_deg + share * (b.lat_deg - a.lat_deg)};
}

LonLat PositionAt(const TimedPoint& from, const TimedPoint& to, double time_s) {
  const double duration_s = to.time_s - from.time_s;
  if (!(duration_s > 0.0)) return from.position;
  const double share = (time_s - from.time_s) / duration_s;
  return Between(from.position, to.position, std::clamp(share, 0.0, 1.0));
}

struct PlaneOffset {
  double east_m = 0.0;
  double north_m = 0.0;
  double length_m() const { return std::hypot(east_m, north_m); }
};

PlaneOffset ComputeOffset(LonLat a, LonLat b,
                          const kg_base::DegreesPerMetre& scale) {
  return {Wrapped(b.lon_deg - a.lon_deg) / scale.lon_deg,
          (b.lat_deg - a.lat_deg) / scale.lat_deg};
}

double MidLatitudeDistance_m(LonLat a, LonLat b) {
  const auto scale = kg_base::LocalScale(0.5 * (a.lat_deg + b.lat_deg));
  return ComputeOffset(a, b, scale).length_m();
}

// Two tracks, both linear in time, between two times.
struct TrackInterval {
  double begin_s = 0.0;
  double end_s = 0.0;
  LonLat a_begin, a_end;
  LonLat b_begin, b_end;
};

// Minimum in the plane, remeasured at the mean latitude of the closest points.
TrackApproach ApproachWithin(const TrackInterval& interval) {
  const auto scale = kg_base::LocalScale(
      0.25 * (interval.a_begin.lat_deg + interval.a_end.lat_deg +
              interval.b_begin.lat_deg + interval.b_end.lat_deg));
  const PlaneOffset begin =
      ComputeOffset(interval.a_begin, interval.b_begin, scale);
  const PlaneOffset end = ComputeOffset(interval.a_end, interval.b_end, scale);
  const double east_m = end.east_m - begin.east_m;
  const double north_m = end.north_m - begin.north_m;
  const double squared = east_m * east_m + north_m * north_m;
  const double along = -(begin.east_m * east_m + begin.north_m * north_m);
  const double share =
      squared > 0.0 ? std::clamp(along / squared, 0.0, 1.0) : 0.0;
  return {
      MidLatitudeDistance_m(Between(interval.a_begin, interval.a_end, share),
                            Between(interval.b_begin, interval.b_end, share)),
      interval.begin_s + share * (interval.end_s - interval.begin_s)};
}

double SmallestMagnitude(double begin, double end) {
  return begin * end > 0.0 ? std::min(std::abs(begin), std::abs(end)) : 0.0;
}

// Lower bound of the approach, from differences of latitude and longitude only:
// a degree is at least 110574 m northward and 111319 m cos(lat) eastward, and
// cos(x) >= 1 - x^2 / 2. Reduced by a share of 1e-6 for rounding.
double LeastPossible_m(const TrackInterval& interval) {
  const double north_deg =
      SmallestMagnitude(interval.b_begin.lat_deg - interval.a_begin.lat_deg,
                        interval.b_end.lat_deg - interval.a_end.lat_deg);
  const double east_deg = SmallestMagnitude(
      Wrapped(interval.b_begin.lon_deg - interval.a_begin.lon_deg),
      Wrapped(interval.b_end.lon_deg - interval.a_end.lon_deg));
  const double lat_rad = kg_base::DegToRad(std::max(
      {std::abs(interval.a_begin.lat_deg), std::abs(interval.a_end.lat_deg),
       std::abs(interval.b_begin.lat_deg), std::abs(interval.b_end.lat_deg)}));
  const double cos_lat = std::max(0.0, 1.0 - 0.5 * lat_rad * lat_rad);
  return 0.999999 *
         std::max(110574.0 * north_deg, 111319.0 * cos_lat * east_deg);
}

// Index of the last point not after time_s.
std::size_t PointAt(const Track& track, double time_s) {
  const auto later = std::upper_bound(
      track.begin(), track.end(), time_s,
      [](double t, const TimedPoint& point) { return t < point.time_s; });
  return later == track.begin() ? 0 : later - track.begin() - 1;
}

// Iterates over the pieces of a track.
class TrackPiece {
 public:
  TrackPiece(const Track& track, double time_s)
      : track_(track), index_(PointAt(track, time_s)) {}

  const TimedPoint& from() const { return track_[index_]; }
  const TimedPoint& to() const {
    return track_[std::min(index_ + 1, track_.size() - 1)];
  }
  bool Advance(double time_s) {
    if (index_ + 2 >= track_.size() || !(to().time_s <= time_s)) return false;
    ++index_;
    return true;
  }
  double EndBefore(double time_s) const {
    return index_ + 1 < track_.size() ? std::min(time_s, to().time_s) : time_s;
  }

 private:
  const Track& track_;
  std::size_t index_;
};

// Time span common to both tracks and `span`; empty if to < from.
TimeSpan CommonSpan(const Track& a, const Track& b, const TimeSpan& span) {
  if (a.empty() || b.empty()) return {0.0, -1.0};
  return {std::max({span.from_s, a.front().time_s, b.front().time_s}),
          std::min({span.to_s, a.back().time_s, b.back().time_s})};
}

// Calls visit(TrackInterval) in order of time until it returns false.
template <typename Visit>
void ForEachInterval(const Track& a, const Track& b, const TimeSpan& span,
                     const Visit& visit) {
  const TimeSpan common = CommonSpan(a, b, span);
  if (!(common.from_s <= common.to_s)) return;
  TrackPiece of_a(a, common.from_s);
  TrackPiece of_b(b, common.from_s);
  double begin_s = common.from_s;
  for (bool more = true; more;) {
    // Up to the earliest end of the two pieces and the span.
    const double end_s =
        std::max(begin_s, of_b.EndBefore(of_a.EndBefore(common.to_s)));
    const TrackInterval interval{begin_s,
                                 end_s,
                                 PositionAt(of_a.from(), of_a.to(), begin_s),
                                 PositionAt(of_a.from(), of_a.to(), end_s),
                                 PositionAt(of_b.from(), of_b.to(), begin_s),
                                 PositionAt(of_b.from(), of_b.to(), end_s)};
    if (!visit(interval)) return;
    begin_s = end_s;
    // Both must advance: avoid short-circuit evaluation.
    const bool a_moved = of_a.Advance(end_s);
    more = of_b.Advance(end_s) || a_moved;
  }
}

}  // namespace

bool operator==(const Visit& a, const Visit& b) {
  const auto same_stop = [](const Stop& one, const Stop& other) {
    return one.waypoint == other.waypoint && one.position == other.position;
  };
  return a.window == b.window && a.waypoint == b.waypoint &&
         a.position == b.position && a.reward == b.reward &&
         a.events == b.events && a.cost == b.cost &&
         std::equal(a.via.begin(), a.via.end(), b.via.begin(), b.via.end(),
                    same_stop);
}

bool IsSamePath(const Pathlet& a, const Pathlet& b) {
  const auto same_stops = [](const Visit& one, const Visit& other) {
    return one.window == other.window && one.events == other.events &&
           StopsOf(one) == StopsOf(other);
  };
  const auto same_point = [](const TimedPoint& one, const TimedPoint& other) {
    return one.time_s == other.time_s && one.position == other.position;
  };
  return a.reward == b.reward && a.seam_cost == b.seam_cost &&
         a.energy_j == b.energy_j &&
         std::equal(a.visits.begin(), a.visits.end(), b.visits.begin(),
                    b.visits.end(), same_stops) &&
         std::equal(a.track.begin(), a.track.end(), b.track.begin(),
                    b.track.end(), same_point);
}

std::vector<int> WaypointsVia(const Visit& visit) {
  std::vector<int> via;
  for (const Stop& stop : visit.via) via.push_back(stop.waypoint);
  return via;
}

std::vector<int> StopsOf(const Visit& visit) {
  std::vector<int> stops = WaypointsVia(visit);
  stops.push_back(visit.waypoint);
  return stops;
}

std::optional<TrackApproach> ClosestApproach(const Track& a, const Track& b,
                                             const TimeSpan& span) {
  std::optional<TrackApproach> closest;
  ForEachInterval(a, b, span, [&](const TrackInterval& interval) {
    const TrackApproach approach = ApproachWithin(interval);
    if (!closest || approach.distance_m < closest->distance_m) {
      closest = approach;
    }
    return true;
  });
  return closest;
}

std::optional<TrackApproach> ClosestApproach(const Track& a, const Track& b) {
  return ClosestApproach(a, b, TimeSpan());
}

bool ComeCloserThan(const Track& a, const Track& b, double distance_m,
                    const TimeSpan& span) {
  bool closer = false;
  ForEachInterval(a, b, span, [&](const TrackInterval& interval) {
    closer = LeastPossible_m(interval) < distance_m &&
             ApproachWithin(interval).distance_m < distance_m;
    return !closer;
  });
  return closer;
}

std::optional<double> FirstTimeApart(const Track& a, const Track& b,
                                     double distance_m, const TimeSpan& span) {
  std::optional<double> first_s;
  const auto apart = [&](LonLat at_a, LonLat at_b) {
    return MidLatitudeDistance_m(at_a, at_b) >= distance_m;
  };
  ForEachInterval(a, b, span, [&](const TrackInterval& interval) {
    if (apart(interval.a_begin, interval.b_begin)) {
      first_s = interval.begin_s;
    } else if (apart(interval.a_end, interval.b_end)) {
      first_s = interval.end_s;
    }
    return !first_s;
  });
  return first_s;
}

}  // namespace kg_selector
