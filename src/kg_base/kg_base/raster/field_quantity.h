// The quantities that can be read from a gridded file, one table row each:
// names in files, units, and valid range. A new quantity needs an enumerator
// and a row (field_quantity.cc). Source of the names: CF-1.8, section 3.3
// (standard names).

#ifndef KG_BASE_RASTER_FIELD_QUANTITY_H_
#define KG_BASE_RASTER_FIELD_QUANTITY_H_

#include <string>
#include <vector>

namespace kg_base {

enum class FieldQuantity {
  // m/s; eastward_sea_water_velocity, ..., eastward_wind; water_u, u
  kEastwardVelocity,
  // m/s; northward_sea_water_velocity, ..., northward_wind; water_v, v
  kNorthwardVelocity,
  // degree Celsius; sea_surface_temperature, ..., surface_temperature,
  // air_temperature; water_temp
  kTemperature,
  // m; sea_surface_wave_significant_height; swh, hs
  kWaveHeight,
  kAny,  // A variable requested by name, in its own unit.
};

// SI (degree Celsius for temperatures) = value * scale + offset.
struct UnitScale {
  const char* name;
  double scale;
  double offset;
};

struct QuantityWords {
  const char* name;                         // "eastward velocity", ...
  std::vector<std::string> standard_names;  // Tried first, in this order.
  std::vector<std::string> variable_names;  // Tried next; lower case.
  // The first is the default if the file has no units. Empty: values keep their
  // own unit.
  std::vector<UnitScale> units;
  double min_value;  // In SI; values outside are no data.
  double max_value;
};

const QuantityWords& WordsFor(FieldQuantity quantity);
// As above, with the limits of the variable's medium (air or water).
QuantityWords WordsFor(FieldQuantity quantity,
                       const std::string& standard_name);

const char* Name(FieldQuantity quantity);  // "eastward velocity", ...

bool IsWindName(const std::string& standard_name);

}  // namespace kg_base

#endif  // KG_BASE_RASTER_FIELD_QUANTITY_H_
