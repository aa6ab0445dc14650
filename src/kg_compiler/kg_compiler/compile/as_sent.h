// Positions rounded as by a message. Messages carry radians, facts and rasters
// degrees, and the conversion to radians and back may change the last bit. The
// rounding is idempotent: AsSent(AsSent(x)) == AsSent(x). Applied to values
// before they are used and sent, it makes every process compute the same
// result, whether it received them by message or not.

#ifndef KG_COMPILER_COMPILE_AS_SENT_H_
#define KG_COMPILER_COMPILE_AS_SENT_H_

#include <utility>
#include <vector>

#include "kg_base/common/units.h"
#include "kg_base/geo/lon_lat.h"
#include "kg_base/raster/grid.h"

namespace kg_compiler {

inline double AngleAsSent(double deg) {
  return kg_base::RadToDeg(kg_base::DegToRad(deg));
}

inline kg_base::LonLat AsSent(kg_base::LonLat position) {
  return {AngleAsSent(position.lon_deg), AngleAsSent(position.lat_deg)};
}

inline kg_base::Grid AsSent(const kg_base::Grid& grid) {
  std::vector<double> lon_deg = grid.lon_deg();
  std::vector<double> lat_deg = grid.lat_deg();
  for (double& angle_deg : lon_deg) angle_deg = AngleAsSent(angle_deg);
  for (double& angle_deg : lat_deg) angle_deg = AngleAsSent(angle_deg);
  return kg_base::Grid(std::move(lon_deg), std::move(lat_deg));
}

}  // namespace kg_compiler

#endif  // KG_COMPILER_COMPILE_AS_SENT_H_
