// Tells what a coordinate variable of a gridded file is: by its attributes,
// standard_name before units; by its name only if they say nothing.
// Source: CF-1.8, section 4.

#ifndef KG_BASE_RASTER_AXIS_ROLE_H_
#define KG_BASE_RASTER_AXIS_ROLE_H_

#include <string>

#include "kg_base/raster/netcdf_file.h"

namespace kg_base {

enum class AxisRole {
  kUnknown,
  kTime,       // When a value holds.
  kOtherTime,  // When a forecast was made, or how far it looks ahead.
  kVertical,
  kLatitude,
  kLongitude,
  kGridCoordinate,  // Rotated pole or map projection.
};

AxisRole RoleOf(const NetcdfVariable& variable);
// For a dimension without a coordinate variable.
AxisRole RoleByName(const std::string& name);
// Higher = more explicit about its role: 3 standard_name, 2 other attributes,
// 1 its name alone, 0 unknown.
int RoleStrength(const NetcdfVariable& variable);

bool IsTimeUnit(const std::string& units);  // "... since ..."

}  // namespace kg_base

#endif  // KG_BASE_RASTER_AXIS_ROLE_H_
