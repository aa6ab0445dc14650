// A position on the WGS84 ellipsoid, as in facts and WKT (CRS84: longitude
// first, degrees). Longitudes are in [-180, 180).

#ifndef KG_BASE_GEO_LON_LAT_H_
#define KG_BASE_GEO_LON_LAT_H_

namespace kg_base {

struct LonLat {
  double lon_deg = 0.0;  // East positive.
  double lat_deg = 0.0;  // North positive.
};

inline bool operator==(const LonLat& a, const LonLat& b) {
  return a.lon_deg == b.lon_deg && a.lat_deg == b.lat_deg;
}
inline bool operator!=(const LonLat& a, const LonLat& b) { return !(a == b); }

}  // namespace kg_base

#endif  // KG_BASE_GEO_LON_LAT_H_
