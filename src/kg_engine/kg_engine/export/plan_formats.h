// A plan in external text formats.

#ifndef KG_ENGINE_EXPORT_PLAN_FORMATS_H_
#define KG_ENGINE_EXPORT_PLAN_FORMATS_H_

#include <cstddef>
#include <string>
#include <vector>

#include "kg_engine/export/plan_tracks.h"

namespace kg_engine {

// A FeatureCollection: each agent's track as a LineString (a MultiLineString if
// it crosses the antimeridian) with the times of its points in the property
// "coordTimes", nested like the coordinates; each stop as a Point.
// https://www.rfc-editor.org/rfc/rfc7946
std::string ToGeoJson(const PlanTracks& plan);

// GPX 1.1: a wpt per stop, a rte of the remaining stops and a trk with times
// per agent.
// https://www.topografix.com/GPX/1/1/
std::string ToGpx(const PlanTracks& plan);

// A goto list has at most so many waypoints.
constexpr std::size_t kMaxGotoWaypoints = 8;
// Begin of the second line of every list.
inline constexpr char kGotoAuthor[] = "# Written by kg/export for ";

// The remaining stops of one agent, as a Slocum glider's waypoint lists of at
// most kMaxGotoWaypoints, to be flown one after the other; none if nothing is
// left to fly. Degrees and minutes as DDDMM.mmmm, longitude first:
//
//   behavior_name=goto_list
//   <start:b_arg>
//     b_arg: num_legs_to_run(nodim) -2    # once through the list
//     b_arg: list_when_wpt_dist(m) 10     # a waypoint is reached within this
//     ...
//   <end:b_arg>
//   <start:waypoints>
//   -9054.0000 2542.0000
//   <end:waypoints>
std::vector<std::string> ToGotoLists(const PlanTracks& plan,
                                     const PlannedAgent& agent);

// Formats -90.9 as "-9054.0000": minutes with four decimals (0.2 m); rounding
// carries into the degrees.
std::string DegreesAndMinutes(double degrees);

}  // namespace kg_engine

#endif  // KG_ENGINE_EXPORT_PLAN_FORMATS_H_
