#include "kg_base/raster/field_quantity.h"

#include <limits>
#include <stdexcept>
#include <utility>

#include "kg_base/common/text.h"

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

// Statistics of a quantity are not the quantity.
constexpr const char* kStatistics[] = {"error",       "anomaly",  "deviation",
                                       "uncertainty", "variance", "quality",
                                       "flag",        "bias",     "trend"};
// A bare u or v is taken as a component of the current, not of these.
constexpr const char* kOtherVelocities[] = {
    "wind", "stokes", "stress", "ice", "transport", "flux", "tidal", "wave"};

// Does the text have the word, or its plural with s?
bool HasWord(const std::string& text, const std::string& word) {
  std::string letters;
  for (const char c : text + " ") {
    if (c >= 'a' && c <= 'z') {
      letters += c;
      continue;
    }
    if (letters == word || letters == word + "s") return true;
    letters.clear();
  }
  return false;
}

bool IsVelocity(FieldQuantity quantity) {
  return quantity == FieldQuantity::kEastwardVelocity ||
         quantity == FieldQuantity::kNorthwardVelocity;
}

// `direction`: "eastward" or "northward".
QuantityWords VelocityWords(const char* name, const std::string& direction,
                            std::vector<std::string> variable_names) {
  const std::string water = direction + "_sea_water_velocity";
  return {name,
          {water, "surface_" + water, water + "_assuming_no_tide",
           direction + "_wind"},
          std::move(variable_names),
          "m/s",
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
      "degC",
      -5.0,
      60.0};
  static const QuantityWords kWaveHeight = {
      "wave height",
      {"sea_surface_wave_significant_height",
       "significant_height_of_wind_and_swell_waves"},
      {"wave_height", "swh", "hs", "vhm0"},
      "m",
      0.0,
      40.0};
  // Selected by variable name only; any finite value is valid.
  static const QuantityWords kAny = {"values",
                                     {},
                                     {},
                                     "",
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

std::string ContradictingWord(FieldQuantity quantity,
                              const std::string& long_name) {
  const std::string text = ToLowerAscii(long_name);
  for (const char* word : kStatistics) {
    if (HasWord(text, word)) return word;
  }
  if (!IsVelocity(quantity)) return "";
  for (const char* word : kOtherVelocities) {
    if (HasWord(text, word)) return word;
  }
  return "";
}

bool IsRelatedName(FieldQuantity quantity, const std::string& standard_name) {
  if (!IsVelocity(quantity)) return false;
  const bool is_east = quantity == FieldQuantity::kEastwardVelocity;
  const auto contains = [&](const char* part) {
    return standard_name.find(part) != std::string::npos;
  };
  return contains("sea_water") && contains("velocity") &&
         (contains(is_east ? "eastward" : "northward") ||
          contains(is_east ? "_x_velocity" : "_y_velocity"));
}

bool IsWindName(const std::string& standard_name) {
  return standard_name == "eastward_wind" || standard_name == "northward_wind";
}

}  // namespace kg_base
