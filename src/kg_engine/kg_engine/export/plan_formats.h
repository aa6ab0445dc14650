// A plan in the formats of others, as text.

#ifndef KG_ENGINE_EXPORT_PLAN_FORMATS_H_
#define KG_ENGINE_EXPORT_PLAN_FORMATS_H_

#include <string>
#include <vector>

#include "kg_engine/export/plan_tracks.h"

namespace kg_engine {

// A FeatureCollection: each agent's way as a LineString (a MultiLineString
// where it passes the antimeridian) with the times of its points in the
// property "coordTimes", nested like the coordinates; each stop as a Point.
// https://www.rfc-editor.org/rfc/rfc7946
std::string ToGeoJson(const PlanTracks& plan);

// GPX 1.1: each stop a wpt, each agent a trk with times.
// https://www.topografix.com/GPX/1/1/
std::string ToGpx(const PlanTracks& plan);

// The stops still to be made of one agent, as a Slocum glider's list of
// waypoints, degrees and minutes as DDDMM.mmmm, longitude first:
//
//   behavior_name=goto_list
//   <start:b_arg>
//     b_arg: num_legs_to_run(nodim) -2   # once through the list
//     ...
//   <end:b_arg>
//   <start:waypoints>
//   -9054.0000 2542.0000
//   <end:waypoints>
std::string ToGotoList(const PlanTracks& plan, const PlannedAgent& agent);

// "-9054.0000" of -90.9: minutes in four decimals (0.2 m), carried into whole
// degrees.
std::string DegreesAndMinutes(double degrees);

}  // namespace kg_engine

#endif  // KG_ENGINE_EXPORT_PLAN_FORMATS_H_
