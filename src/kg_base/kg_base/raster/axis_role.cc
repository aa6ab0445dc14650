#include "kg_base/raster/axis_role.h"

#include <algorithm>
#include <initializer_list>

#include "kg_base/common/text.h"
#include "kg_base/raster/unit_conversion.h"

namespace kg_base {
namespace {

bool IsOneOf(const std::string& text, std::initializer_list<const char*> list) {
  return std::find(list.begin(), list.end(), text) != list.end();
}

bool ContainsOneOf(const std::string& text,
                   std::initializer_list<const char*> list) {
  return std::any_of(list.begin(), list.end(), [&](const char* part) {
    return text.find(part) != std::string::npos;
  });
}

// Standard names of the axes that CF defines (chapter 4 and appendix D).
AxisRole RoleByStandardName(const std::string& standard) {
  if (standard == "latitude") return AxisRole::kLatitude;
  if (standard == "longitude") return AxisRole::kLongitude;
  if (standard == "time") return AxisRole::kTime;
  if (IsOneOf(standard, {"forecast_reference_time", "forecast_period"})) {
    return AxisRole::kOtherTime;
  }
  if (ContainsOneOf(standard, {"grid_latitude", "grid_longitude",
                               "projection_x_", "projection_y_"})) {
    return AxisRole::kGridCoordinate;
  }
  if (standard.compare(0, 5, "depth") == 0 ||
      standard.compare(0, 6, "height") == 0 ||
      ContainsOneOf(standard, {"_coordinate", "air_pressure",
                               "sea_water_pressure", "altitude",
                               "geopotential_height", "model_level_number"})) {
    return AxisRole::kVertical;
  }
  return AxisRole::kUnknown;
}

// All spellings that CF allows (4.1, 4.2); plain "degrees" is ambiguous.
AxisRole RoleByUnits(const std::string& units) {
  if (IsOneOf(units, {"degrees_north", "degree_north", "degrees_N", "degree_N",
                      "degreesN", "degreeN"})) {
    return AxisRole::kLatitude;
  }
  if (IsOneOf(units, {"degrees_east", "degree_east", "degrees_E", "degree_E",
                      "degreesE", "degreeE"})) {
    return AxisRole::kLongitude;
  }
  return AxisRole::kUnknown;
}

// The role of a variable in units of time since a date: either when a value
// holds, or something else about a forecast.
AxisRole RoleOfDates(const NetcdfVariable& variable) {
  const std::string name = ToLowerAscii(variable.base_name);
  const std::string long_name = ToLowerAscii(variable.Text("long_name"));
  const bool is_other =
      ContainsOneOf(name, {"ref", "analysis", "run", "lead", "issue", "cycle",
                           "init", "tau", "creation"}) ||
      ContainsOneOf(long_name, {"reference time", "analysis time", "run time",
                                "lead time", "issue time", "cycle time",
                                "forecast period", "creation time"});
  // "hours since analysis" names no date.
  const std::string units = ToLowerAscii(variable.Text("units"));
  const std::size_t date =
      units.find_first_not_of(' ', units.find(" since ") + 7);
  const bool has_date =
      date != std::string::npos && units[date] >= '0' && units[date] <= '9';
  return is_other || !has_date ? AxisRole::kOtherTime : AxisRole::kTime;
}

AxisRole RoleByVerticalHints(const NetcdfVariable& variable) {
  const std::string positive = ToLowerAscii(variable.Text("positive"));
  if (variable.Text("axis") == "Z" || positive == "down" || positive == "up") {
    return AxisRole::kVertical;
  }
  const std::string long_name = ToLowerAscii(variable.Text("long_name"));
  const bool is_pressure =
      ConvertUnit(variable.Text("units"), "Pa").has_value();
  if (is_pressure ||
      ContainsOneOf(long_name, {"depth", "height above", "altitude", "sigma",
                                "pressure level"})) {
    return AxisRole::kVertical;
  }
  return AxisRole::kUnknown;
}

AxisRole RoleByAttributes(const NetcdfVariable& variable) {
  const std::string standard = variable.Text("standard_name");
  const std::string units = variable.Text("units");
  const AxisRole named = RoleByStandardName(standard);
  if (named != AxisRole::kUnknown) return named;
  const std::string long_name = ToLowerAscii(variable.Text("long_name"));
  if (ContainsOneOf(long_name, {"rotated"})) return AxisRole::kGridCoordinate;
  const AxisRole measured = RoleByUnits(units);
  if (measured != AxisRole::kUnknown) return measured;
  if (IsTimeUnit(units)) {
    return standard.empty() ? RoleOfDates(variable) : AxisRole::kOtherTime;
  }
  return RoleByVerticalHints(variable);
}

// A unit may confirm what a name says, or contradict it: lon in "1" or "m"
// counts columns or metres.
bool UnitFitsName(AxisRole role, const NetcdfVariable& variable) {
  const std::string units = variable.Text("units");
  if (units.empty()) return true;
  if (role == AxisRole::kLatitude || role == AxisRole::kLongitude) {
    const std::optional<UnitScale> scale = ConvertUnit(units, "degree");
    return scale && scale->scale == 1.0;
  }
  return true;
}

}  // namespace

bool IsTimeUnit(const std::string& units) {
  return ToLowerAscii(units).find(" since ") != std::string::npos;
}

AxisRole RoleByName(const std::string& any_case) {
  const std::string name = ToLowerAscii(any_case);
  if (IsOneOf(name, {"lat", "latitude", "nav_lat"})) return AxisRole::kLatitude;
  if (IsOneOf(name, {"lon", "longitude", "nav_lon"})) {
    return AxisRole::kLongitude;
  }
  if (IsOneOf(name, {"time", "mt", "t", "ocean_time"})) return AxisRole::kTime;
  if (IsOneOf(name, {"depth", "lev", "level", "deptht", "z", "layer"})) {
    return AxisRole::kVertical;
  }
  return AxisRole::kUnknown;
}

AxisRole RoleOf(const NetcdfVariable& variable) {
  const AxisRole role = RoleByAttributes(variable);
  if (role != AxisRole::kUnknown) return role;
  if (!variable.Text("standard_name").empty()) return AxisRole::kUnknown;
  const AxisRole named = RoleByName(variable.base_name);
  return UnitFitsName(named, variable) ? named : AxisRole::kUnknown;
}

int RoleStrength(const NetcdfVariable& variable) {
  const AxisRole role = RoleOf(variable);
  if (role == AxisRole::kUnknown) return 0;
  if (RoleByStandardName(variable.Text("standard_name")) == role) return 3;
  return RoleByAttributes(variable) == role ? 2 : 1;
}

}  // namespace kg_base
