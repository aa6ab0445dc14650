// Conversion of the units of facts to SI; the only place where it happens.
//
// Facts use operators' units (knots, hours, kilometres, watt-hours, compass
// degrees); everything behind the knowledge graph's boundary is SI and radians.

#ifndef KG_BASE_COMMON_UNITS_H_
#define KG_BASE_COMMON_UNITS_H_

#include <limits>

namespace kg_base {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr double kPi = 3.14159265358979323846;
inline constexpr double kSecondsPerHour = 3600.0;
inline constexpr double kMetresPerKm = 1000.0;
inline constexpr double kMpsPerKnot = 1852.0 / 3600.0;  // Exact, by definition.
inline constexpr double kJoulesPerWh = 3600.0;

constexpr double KnotsToMps(double knots) { return knots * kMpsPerKnot; }
constexpr double HoursToSeconds(double hours) {
  return hours * kSecondsPerHour;
}
constexpr double KmToMetres(double km) { return km * kMetresPerKm; }
constexpr double WhToJoules(double wh) { return wh * kJoulesPerWh; }
constexpr double WhPerKmToJoulesPerMetre(double wh_per_km) {
  return wh_per_km * kJoulesPerWh / kMetresPerKm;
}
constexpr double DegToRad(double deg) { return deg * kPi / 180.0; }
constexpr double RadToDeg(double rad) { return rad * 180.0 / kPi; }

}  // namespace kg_base

#endif  // KG_BASE_COMMON_UNITS_H_
