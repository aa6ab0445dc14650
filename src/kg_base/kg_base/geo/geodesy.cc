#include "kg_base/geo/geodesy.h"

#include <GeographicLib/Geodesic.hpp>
#include <cmath>

#include "kg_base/common/units.h"

namespace kg_base {
namespace {

using GeographicLib::Geodesic;

// WGS84, NIMA TR8350.2: semi-major axis and flattening.
constexpr double kSemiMajor_m = 6378137.0;
constexpr double kFlattening = 1.0 / 298.257223563;
constexpr double kEccentricitySquared = kFlattening * (2.0 - kFlattening);

}  // namespace

double Distance_m(LonLat a, LonLat b) {
  double distance_m = 0.0;
  Geodesic::WGS84().Inverse(a.lat_deg, a.lon_deg, b.lat_deg, b.lon_deg,
                            distance_m);
  return distance_m;
}

double Bearing_rad(LonLat a, LonLat b) {
  double bearing_deg = 0.0;
  double arrival_deg = 0.0;
  Geodesic::WGS84().Inverse(a.lat_deg, a.lon_deg, b.lat_deg, b.lon_deg,
                            bearing_deg, arrival_deg);
  const double bearing_rad =
      DegToRad(bearing_deg < 0.0 ? bearing_deg + 360.0 : bearing_deg);
  // A tiny negative bearing plus a turn may round to the turn; -0 becomes 0.
  return bearing_rad >= 2.0 * kPi ? 0.0 : std::abs(bearing_rad);
}

LonLat Destination(LonLat from, double bearing_rad, double distance_m) {
  LonLat to;
  Geodesic::WGS84().Direct(from.lat_deg, from.lon_deg, RadToDeg(bearing_rad),
                           distance_m, to.lat_deg, to.lon_deg);
  if (to.lon_deg >= 180.0) to.lon_deg -= 360.0;
  return to;
}

// M = a (1 - e^2) / w^3 and N = a / w with w = sqrt(1 - e^2 sin^2 lat).
DegreesPerMetre LocalScale(double lat_deg) {
  const double lat_rad = DegToRad(lat_deg);
  const double sin_lat = std::sin(lat_rad);
  const double w = std::sqrt(1.0 - kEccentricitySquared * sin_lat * sin_lat);
  const double prime_vertical_m = kSemiMajor_m / w;
  const double meridian_m =
      kSemiMajor_m * (1.0 - kEccentricitySquared) / (w * w * w);
  return {RadToDeg(1.0 / (prime_vertical_m * std::cos(lat_rad))),
          RadToDeg(1.0 / meridian_m)};
}

}  // namespace kg_base
