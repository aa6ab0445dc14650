#include "kg_base/geo/map_projection.h"

#include <cmath>

#include "kg_base/geo/geodesy.h"

namespace kg_base {
namespace {

// Normalises a longitude, or a difference of longitudes, to [-180, 180) deg.
double WrapLon(double lon_deg) {
  if (lon_deg >= -180.0 && lon_deg < 180.0) return lon_deg;
  const double wrapped = std::remainder(lon_deg, 360.0);
  return wrapped >= 180.0 ? wrapped - 360.0 : wrapped;
}

}  // namespace

MapProjection::MapProjection(LonLat centre) : centre_(centre) {
  const DegreesPerMetre scale = LocalScale(centre.lat_deg);
  metres_per_lon_deg_ = 1.0 / scale.lon_deg;
  metres_per_lat_deg_ = 1.0 / scale.lat_deg;
}

MapPoint MapProjection::Forward(LonLat position) const {
  return {WrapLon(position.lon_deg - centre_.lon_deg) * metres_per_lon_deg_,
          (position.lat_deg - centre_.lat_deg) * metres_per_lat_deg_};
}

LonLat MapProjection::Inverse(MapPoint point) const {
  return {WrapLon(centre_.lon_deg + point.x_m / metres_per_lon_deg_),
          centre_.lat_deg + point.y_m / metres_per_lat_deg_};
}

}  // namespace kg_base
