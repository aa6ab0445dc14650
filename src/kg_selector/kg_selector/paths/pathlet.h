// One agent's proposal for the whole horizon, as the selector weighs it.

#ifndef KG_SELECTOR_PATHS_PATHLET_H_
#define KG_SELECTOR_PATHS_PATHLET_H_

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "kg_base/geo/lon_lat.h"
#include "kg_compiler/control_plane/edge_cost.h"
#include "kg_compiler/traversal/traversal.h"

namespace kg_selector {

struct Stop {
  int waypoint = 0;  // Id in the agent's NavGraph of the window.
  kg_base::LonLat position;
};

// One window: stops on the way, then the place where it ends.
struct Visit {
  int window = 0;
  int waypoint = 0;  // Id in the agent's NavGraph of that window.
  kg_base::LonLat position;
  double reward = 0.0;              // Of the window, stops included.
  std::vector<std::string> events;  // IRIs of events that reward the window.
  std::vector<Stop> via = {};
  kg_compiler::EdgeCost cost = {};  // Of the whole way through the window.
  // Index of the edge taken among those of the NavGraph; -1 = not known, as in
  // a pathlet that came by message.
  int edge = -1;
};
// But for the index of the edge.
bool operator==(const Visit& a, const Visit& b);

std::vector<int> WaypointsVia(const Visit& visit);  // Waypoints on the way.
std::vector<int> StopsOf(const Visit& visit);       // And where it ends.

struct Pathlet {
  std::string agent;  // Its name in the team (NameOf(), priced_replanning.h).
  int rank = 0;       // In the agent's own order, 0 = best,
  int round = 0;      // of the offer that it was part of.
  double reward = 0.0;
  double seam_cost = 0.0;
  double energy_j = 0.0;
  std::vector<Visit> visits;                   // One a window, ascending.
  std::vector<kg_compiler::TimedPoint> track;  // Where it is when.
  double score() const { return reward - seam_cost; }
};

// Equal figures, visits and tracks, whoever offered them in which round.
bool IsSamePath(const Pathlet& a, const Pathlet& b);

// Closest approach of two tracks while both exist [m]; straight (in longitude
// and latitude) and steady between points, whose times must not descend.
// Nothing if they never exist at the same time. Longitudes may pass 180
// degrees.
//
// Closed form on every common interval, in the plane of WGS84's radii of
// curvature at the middle latitude of the two. Against the geodesic: 0.01 % up
// to 20 km between the polar circles, for pieces of a track up to 20 km; the
// further apart the worse.
struct TrackApproach {
  double distance_m = 0.0;
  double time_s = 0.0;
};
std::optional<TrackApproach> ClosestApproach(
    const std::vector<kg_compiler::TimedPoint>& a,
    const std::vector<kg_compiler::TimedPoint>& b);

// The same within a span of time only.
struct TimeSpan {
  double from_s = -std::numeric_limits<double>::infinity();
  double to_s = std::numeric_limits<double>::infinity();
};
std::optional<TrackApproach> ClosestApproach(
    const std::vector<kg_compiler::TimedPoint>& a,
    const std::vector<kg_compiler::TimedPoint>& b, const TimeSpan& span);

// ClosestApproach() < distance_m, sooner.
bool ComeCloserThan(const std::vector<kg_compiler::TimedPoint>& a,
                    const std::vector<kg_compiler::TimedPoint>& b,
                    double distance_m, const TimeSpan& span);

// The first time in `span` at which they are at least `distance_m` apart, of
// those at which a piece of either track or the span begins or ends.
std::optional<double> FirstTimeApart(
    const std::vector<kg_compiler::TimedPoint>& a,
    const std::vector<kg_compiler::TimedPoint>& b, double distance_m,
    const TimeSpan& span);

}  // namespace kg_selector

#endif  // KG_SELECTOR_PATHS_PATHLET_H_
