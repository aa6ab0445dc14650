#include "kg_base/raster/field_quantity.h"

#include <limits>
#include <stdexcept>
#include <utility>

namespace kg_base {
namespace {

// Valid range by standard name, where it differs from that of sea water.
struct MediumLimits {
  const char* standard_name;
  double min_value;
  double max_value;
};
constexpr MediumLimits kOtherMedia[] = {
    {"eastward_wind", -120.0, 120.0},
    {"northward_wind", -120.0, 120.0},
    {"air_temperature", -100.0, 100.0},
    {"surface_temperature", -100.0, 2000.0}};

const std::vector<UnitScale>& SpeedUnits() {
  static const std::vector<UnitScale> kUnits = {
      {"m/s", 1, 0},           {"m s-1", 1, 0},
      {"m s**-1", 1, 0},       {"m s^-1", 1, 0},
      {"m.s-1", 1, 0},         {"ms-1", 1, 0},
      {"meter/sec", 1, 0},     {"meter/second", 1, 0},
      {"meters/second", 1, 0}, {"meter second-1", 1, 0},
      {"meters/sec", 1, 0},    {"cm/s", 0.01, 0},
      {"cm s-1", 0.01, 0},
  };
  return kUnits;
}

const std::vector<UnitScale>& TemperatureUnits() {
  static const std::vector<UnitScale> kUnits = {
      {"degC", 1, 0},
      {"degree_C", 1, 0},
      {"degrees_C", 1, 0},
      {"degree_Celsius", 1, 0},
      {"degrees_Celsius", 1, 0},
      {"degree Celsius", 1, 0},
      {"degrees Celsius", 1, 0},
      {"Celsius", 1, 0},
      {"celsius", 1, 0},
      {"degrees C", 1, 0},
      {"deg C", 1, 0},
      {"C", 1, 0},
      {"K", 1, -273.15},
      {"kelvin", 1, -273.15},
      {"Kelvin", 1, -273.15},
      {"degrees_K", 1, -273.15},
      {"degK", 1, -273.15},
  };
  return kUnits;
}

const std::vector<UnitScale>& LengthUnits() {
  static const std::vector<UnitScale> kUnits = {
      {"m", 1, 0},      {"meter", 1, 0}, {"meters", 1, 0},   {"metre", 1, 0},
      {"metres", 1, 0}, {"cm", 0.01, 0}, {"feet", 0.3048, 0}};
  return kUnits;
}

// `direction`: "eastward" or "northward".
QuantityWords VelocityWords(const char* name, const std::string& direction,
                            std::vector<std::string> variable_names) {
  const std::string water = direction + "_sea_water_velocity";
  return {name,
          {water, "surface_" + water, water + "_assuming_no_tide",
           direction + "_wind"},
          std::move(variable_names),
          SpeedUnits(),
          -10.0,
          10.0};
}

}  // namespace

const QuantityWords& WordsFor(FieldQuantity quantity) {
  static const QuantityWords kEast =
      VelocityWords("eastward velocity", "eastward", {"water_u", "u", "uo"});
  static const QuantityWords kNorth =
      VelocityWords("northward velocity", "northward", {"water_v", "v", "vo"});
  static const QuantityWords kTemperature = {
      "temperature",
      {"sea_surface_temperature", "sea_water_temperature",
       "sea_water_potential_temperature", "sea_water_conservative_temperature",
       "sea_surface_foundation_temperature", "sea_surface_skin_temperature",
       "sea_surface_subskin_temperature", "surface_temperature",
       "air_temperature"},
      {"water_temp", "temperature", "temp", "sst", "thetao", "analysed_sst"},
      TemperatureUnits(),
      -5.0,
      60.0};
  static const QuantityWords kWaveHeight = {
      "wave height",
      {"sea_surface_wave_significant_height",
       "significant_height_of_wind_and_swell_waves"},
      {"wave_height", "swh", "hs", "vhm0"},
      LengthUnits(),
      0.0,
      40.0};
  // Selected by variable name only; any finite value is valid.
  static const QuantityWords kAny = {"values",
                                     {},
                                     {},
                                     {},
                                     -std::numeric_limits<float>::max(),
                                     std::numeric_limits<float>::max()};
  switch (quantity) {
    case FieldQuantity::kEastwardVelocity:
      return kEast;
    case FieldQuantity::kNorthwardVelocity:
      return kNorth;
    case FieldQuantity::kTemperature:
      return kTemperature;
    case FieldQuantity::kWaveHeight:
      return kWaveHeight;
    case FieldQuantity::kAny:
      return kAny;
  }
  throw std::logic_error("no such quantity");
}

QuantityWords WordsFor(FieldQuantity quantity,
                       const std::string& standard_name) {
  QuantityWords words = WordsFor(quantity);
  if (quantity == FieldQuantity::kAny) return words;
  for (const MediumLimits& limits : kOtherMedia) {
    if (standard_name != limits.standard_name) continue;
    words.min_value = limits.min_value;
    words.max_value = limits.max_value;
  }
  return words;
}

const char* Name(FieldQuantity quantity) { return WordsFor(quantity).name; }

bool IsWindName(const std::string& standard_name) {
  return standard_name == "eastward_wind" || standard_name == "northward_wind";
}

}  // namespace kg_base
