// Lengths and directions on WGS84, by GeographicLib's geodesics.

#ifndef KG_BASE_GEO_GEODESY_H_
#define KG_BASE_GEO_GEODESY_H_

#include "kg_base/geo/lon_lat.h"

namespace kg_base {

// Length of the geodesic between two positions [m].
double Distance_m(LonLat a, LonLat b);

// Initial bearing from a to b, rad clockwise from true north, in [0, 2 pi).
double Bearing_rad(LonLat a, LonLat b);

// End of the geodesic that starts at `from` with the given initial bearing [rad
// clockwise from north] and length [m].
LonLat Destination(LonLat from, double bearing_rad, double distance_m);

// Degrees moved per metre travelled east or north at a latitude: 1 / (N cos
// lat) and 1 / M with WGS84's radii of curvature in the prime vertical (N) and
// in the meridian (M).
struct DegreesPerMetre {
  double lon_deg;
  double lat_deg;
};
DegreesPerMetre LocalScale(double lat_deg);

}  // namespace kg_base

#endif  // KG_BASE_GEO_GEODESY_H_
