// One agent's candidate path over the whole horizon, as ranked by the selector.

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
  double reward = 0.0;              // Reward of the window, stops included.
  std::vector<std::string> events;  // IRIs of the events earned in the window.
  std::vector<Stop> via = {};
  kg_compiler::EdgeCost cost = {};  // Cost of the whole way through the window.
  // Index of the edge taken among those of the NavGraph; -1 = not known, as in
  // a pathlet that came by message.
  int edge = -1;
};
// Compares all members except `edge`.
bool operator==(const Visit& a, const Visit& b);

std::vector<int> WaypointsVia(const Visit& visit);  // Waypoints on the way.
std::vector<int> StopsOf(const Visit& visit);       // Stops, then the end.

struct Pathlet {
  std::string agent;  // Name in the team (NameOf(), priced_replanning.h).
  int rank = 0;       // Rank in the agent's own order, 0 = best.
  int round = 0;      // Round of the offer that contained it.
  double reward = 0.0;
  double seam_cost = 0.0;
  double energy_j = 0.0;
  std::vector<Visit> visits;                   // One per window, ascending.
  std::vector<kg_compiler::TimedPoint> track;  // Position over time.
  double score() const { return reward - seam_cost; }
};

// True if reward, seam cost, energy, track and the waypoints and events of each
// visit are equal. Agent, rank, round, and how reward and cost are divided
// among the visits are ignored: they may differ between two offers of one path.
bool IsSamePath(const Pathlet& a, const Pathlet& b);

// Closest approach of two tracks while both exist [m]; position is linear (in
// longitude and latitude) between points, whose times must not decrease.
// nullopt if they never exist at the same time. Longitudes may cross 180
// degrees.
//
// Closed form on every common interval, in the plane of WGS84's radii of
// curvature at the mean latitude of the two. Relative error to the geodesic:
// 0.01 % up to 20 km between the polar circles, for track pieces up to 20 km;
// it grows with the distance.
struct TrackApproach {
  double distance_m = 0.0;
  double time_s = 0.0;
};
std::optional<TrackApproach> ClosestApproach(
    const std::vector<kg_compiler::TimedPoint>& a,
    const std::vector<kg_compiler::TimedPoint>& b);

// Time interval to which the search is restricted.
struct TimeSpan {
  double from_s = -std::numeric_limits<double>::infinity();
  double to_s = std::numeric_limits<double>::infinity();
};
std::optional<TrackApproach> ClosestApproach(
    const std::vector<kg_compiler::TimedPoint>& a,
    const std::vector<kg_compiler::TimedPoint>& b, const TimeSpan& span);

// ClosestApproach() < distance_m, with early exit.
bool ComeCloserThan(const std::vector<kg_compiler::TimedPoint>& a,
                    const std::vector<kg_compiler::TimedPoint>& b,
                    double distance_m, const TimeSpan& span);

// The first time in `span` at which the tracks are at least `distance_m` apart,
// among the times at which a piece of either track or the span begins or ends.
std::optional<double> FirstTimeApart(
    const std::vector<kg_compiler::TimedPoint>& a,
    const std::vector<kg_compiler::TimedPoint>& b, double distance_m,
    const TimeSpan& span);

}  // namespace kg_selector

#endif  // KG_SELECTOR_PATHS_PATHLET_H_
