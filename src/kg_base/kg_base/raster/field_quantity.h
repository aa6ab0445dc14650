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

struct QuantityWords {
  const char* name;                         // "eastward velocity", ...
  std::vector<std::string> standard_names;  // Tried first, in this order.
  std::vector<std::string> variable_names;  // Tried next; lower case.
  // Values are converted to it; assumed if the file names no unit. Empty:
  // values keep their own unit.
  std::string unit;
  double min_value;  // In SI; values outside are no data.
  double max_value;
};

const QuantityWords& WordsFor(FieldQuantity quantity);
// As above, with the limits of the variable's medium (air or water).
QuantityWords WordsFor(FieldQuantity quantity,
                       const std::string& standard_name);

const char* Name(FieldQuantity quantity);  // "eastward velocity", ...

// Words of a long_name that say that a variable with a usual name is another
// quantity, such as "wind" for one named u; "" if there are none.
std::string ContradictingWord(FieldQuantity quantity,
                              const std::string& long_name);

// Is a variable of this standard name, or of this name if it has none, about
// the same quantity in some way, as the tide alone is about the current?
bool IsRelatedName(FieldQuantity quantity, const std::string& standard_name);

bool IsWindName(const std::string& standard_name);

}  // namespace kg_base

#endif  // KG_BASE_RASTER_FIELD_QUANTITY_H_
