// The frame "map": the only conversion between WGS84 and the plane shown by
// rviz and tf. It is not used for measurements: lengths are geodesics.
//
// Equidistant cylindrical (equirectangular) about the domain's centre
// (lon0, lat0), x east, y north, metres:
//
//   x = R_N cos(lat0) (lon - lon0)      y = R_M (lat - lat0)     angles in rad
//
// with the WGS84 radii of curvature R_N (prime vertical) and R_M (meridian) at
// lat0. Exact in scale along the central parallel and at the centre; a regular
// longitude/latitude grid stays a regular grid.
// Source: Snyder, Map Projections - A Working Manual, USGS PP 1395, ch. 12.

#ifndef KG_BASE_GEO_MAP_PROJECTION_H_
#define KG_BASE_GEO_MAP_PROJECTION_H_

#include "kg_base/geo/lon_lat.h"

namespace kg_base {

struct MapPoint {
  double x_m = 0.0;  // East.
  double y_m = 0.0;  // North.
};

class MapProjection {
 public:
  explicit MapProjection(LonLat centre);
  MapPoint Forward(LonLat position) const;
  LonLat Inverse(MapPoint point) const;
  LonLat centre() const { return centre_; }

 private:
  LonLat centre_;
  double metres_per_lon_deg_;
  double metres_per_lat_deg_;
};

}  // namespace kg_base

#endif  // KG_BASE_GEO_MAP_PROJECTION_H_
