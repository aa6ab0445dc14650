#include "kg_core/raster/field_values.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "kg_core/base/text.h"

namespace kg_core {
namespace {

constexpr float kNoData = std::numeric_limits<float>::quiet_NaN();

struct UnitScale {
  const char* name;
  double scale;  // SI = value * scale + offset.
  double offset;
};

// How files speak of a quantity, and what values it can have.
struct Vocabulary {
  const char* name;
  std::vector<std::string> standard_names;
  std::vector<std::string> variable_names;  // Lower case.
  std::vector<UnitScale> units;  // The first holds where none is named; none:
                                 // values stay in their own.
  double least;
  double most;
};

// What is not of the sea has other limits.
struct Limits {
  const char* standard_name;
  double least;
  double most;
};
constexpr Limits kElsewhere[] = {{"eastward_wind", -120.0, 120.0},
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

const Vocabulary& VocabularyOf(FieldQuantity quantity) {
  static const Vocabulary kEast = {
      "eastward velocity",
      {"eastward_sea_water_velocity", "surface_eastward_sea_water_velocity",
       "eastward_sea_water_velocity_assuming_no_tide", "eastward_wind"},
      {"water_u", "u", "uo"},
      SpeedUnits(),
      -10.0,
      10.0};
  static const Vocabulary kNorth = {
      "northward velocity",
      {"northward_sea_water_velocity", "surface_northward_sea_water_velocity",
       "northward_sea_water_velocity_assuming_no_tide", "northward_wind"},
      {"water_v", "v", "vo"},
      SpeedUnits(),
      -10.0,
      10.0};
  static const Vocabulary kTemperature = {
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
  static const Vocabulary kWaveHeight = {
      "wave height",
      {"sea_surface_wave_significant_height",
       "significant_height_of_wind_and_swell_waves"},
      {"wave_height", "swh", "hs", "vhm0"},
      LengthUnits(),
      0.0,
      40.0};
  static const Vocabulary kAny = {"values",
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

// Those of the variable's standard_name, else the quantity's.
Vocabulary WordsFor(FieldQuantity quantity, const NetcdfVariable& variable) {
  Vocabulary words = VocabularyOf(quantity);
  if (quantity == FieldQuantity::kAny) return words;
  const std::string name = variable.Text("standard_name");
  for (const Limits& limits : kElsewhere) {
    if (name != limits.standard_name) continue;
    words.least = limits.least;
    words.most = limits.most;
  }
  return words;
}

std::string Join(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) {
    text += (text.empty() ? "" : ", ") + word;
  }
  return text;
}

// Of several variables with one standard name, the one with a usual name.
const NetcdfVariable* ByStandardName(const NetcdfFile& file,
                                     const Vocabulary& words,
                                     const std::string& standard_name) {
  std::vector<const NetcdfVariable*> found;
  for (const NetcdfVariable& variable : file.variables()) {
    if (variable.Text("standard_name") == standard_name) {
      found.push_back(&variable);
    }
  }
  if (found.size() < 2) return found.empty() ? nullptr : found.front();
  for (const std::string& name : words.variable_names) {
    for (const NetcdfVariable* variable : found) {
      if (ToLowerAscii(variable->name) == name) return variable;
    }
  }
  file.Refuse("variables " + found[0]->name + " and " + found[1]->name +
              " both have standard_name " + standard_name +
              ", expected one, or one named " + Join(words.variable_names));
}

const NetcdfVariable* FindVariable(const NetcdfFile& file,
                                   const Vocabulary& words) {
  for (const std::string& standard_name : words.standard_names) {
    const NetcdfVariable* found = ByStandardName(file, words, standard_name);
    if (found != nullptr) return found;
  }
  for (const std::string& name : words.variable_names) {
    for (const NetcdfVariable& variable : file.variables()) {
      const bool silent = variable.Text("standard_name").empty();
      if (silent && ToLowerAscii(variable.name) == name) return &variable;
    }
  }
  return nullptr;
}

UnitScale ScaleOf(const NetcdfFile& file, const NetcdfVariable& variable,
                  const Vocabulary& words) {
  if (words.units.empty()) return {"", 1.0, 0.0};
  const std::string units = variable.Text("units");
  if (units.empty()) return words.units.front();
  for (const UnitScale& unit : words.units) {
    if (units == unit.name) return unit;
  }
  file.Refuse(variable, "unit \"" + units.substr(0, 100) +
                            "\" is not understood, expected for example \"" +
                            words.units.front().name + "\"");
}

double Single(const NetcdfFile& file, const NetcdfVariable& variable,
              const std::string& attribute, double absent) {
  if (variable.texts.count(attribute) > 0) {
    file.Refuse(variable, "attribute " + attribute + ": expected a number");
  }
  const auto found = variable.numbers.find(attribute);
  if (found == variable.numbers.end()) return absent;
  if (found->second.size() != 1 || !std::isfinite(found->second[0])) {
    file.Refuse(variable, "attribute " + attribute + ": expected one number");
  }
  return found->second[0];
}

// The library's own fill for values that nobody wrote. Bytes have none, every
// value of them is usual.
std::vector<double> DefaultFill(nc_type type) {
  switch (type) {
    case NC_SHORT:
      return {NC_FILL_SHORT};
    case NC_USHORT:
      return {NC_FILL_USHORT};
    case NC_INT:
      return {NC_FILL_INT};
    case NC_UINT:
      return {NC_FILL_UINT};
    case NC_FLOAT:
    case NC_DOUBLE:
      return {NC_FILL_DOUBLE};
    default:
      return {};
  }
}

class Unpacker {
 public:
  Unpacker(const NetcdfFile& file, const NetcdfVariable& variable,
           const Vocabulary& words)
      : is_float_(variable.type == NC_FLOAT),
        least_(words.least),
        most_(words.most) {
    if (ToLowerAscii(variable.Text("_Unsigned")) == "true") {
      file.Refuse(variable, "attribute _Unsigned is not understood");
    }
    const UnitScale unit = ScaleOf(file, variable, words);
    const double scale = Single(file, variable, "scale_factor", 1.0);
    const double offset = Single(file, variable, "add_offset", 0.0);
    if (scale == 0.0) {
      file.Refuse(variable, "attribute scale_factor: expected other than 0");
    }
    scale_ = scale * unit.scale;
    offset_ = offset * unit.scale + unit.offset;
    AddFill(DefaultFill(variable.type));
    for (const char* attribute : {"_FillValue", "missing_value"}) {
      const auto found = variable.numbers.find(attribute);
      if (found != variable.numbers.end()) AddFill(found->second);
    }
  }

  // Of a raw value; counts what it meets.
  float operator()(double raw) {
    if (!std::isfinite(raw) || IsFill(raw)) return kNoData;
    const double value = raw * scale_ + offset_;
    if (value >= least_ && value <= most_) {
      ++plausible_;
      return static_cast<float>(value);
    }
    ++absurd_;
    return kNoData;
  }
  std::size_t plausible() const { return plausible_; }
  std::size_t absurd() const { return absurd_; }

 private:
  // A float variable's fill may be written as a double: both in its own type.
  double InOwnType(double value) const {
    const bool narrow =
        is_float_ && std::abs(value) <= std::numeric_limits<float>::max();
    return narrow ? static_cast<float>(value) : value;
  }
  void AddFill(const std::vector<double>& values) {
    for (const double value : values) fill_.push_back(InOwnType(value));
  }
  bool IsFill(double raw) const {
    return std::find(fill_.begin(), fill_.end(), raw) != fill_.end();
  }

  bool is_float_;
  double least_;
  double most_;
  double scale_ = 1.0;
  double offset_ = 0.0;
  std::vector<double> fill_;
  std::size_t plausible_ = 0;
  std::size_t absurd_ = 0;
};

std::vector<double> RawSlice(const NetcdfFile& file, const FieldAxes& axes,
                             const NetcdfVariable& variable, std::size_t time) {
  std::vector<std::size_t> start = axes.start;
  std::vector<std::size_t> count(start.size(), 1);
  if (axes.time >= 0) start[axes.time] = time;
  count[axes.lat] = axes.file_row.size();
  count[axes.lon] = axes.file_col.size();
  return file.Values(variable, start, count);
}

Raster Canonical(const FieldAxes& axes, const std::vector<double>& raw,
                 Unpacker* unpack) {
  const bool rows_first = axes.lat < axes.lon;
  const std::size_t row_step = rows_first ? axes.file_col.size() : 1;
  const std::size_t col_step = rows_first ? 1 : axes.file_row.size();
  Raster raster;
  raster.reserve(raw.size());
  for (const std::size_t row : axes.file_row) {
    for (const std::size_t col : axes.file_col) {
      raster.push_back((*unpack)(raw[row * row_step + col * col_step]));
    }
  }
  return raster;
}

void RefuseAbsurd(const NetcdfFile& file, const NetcdfVariable& variable,
                  const Vocabulary& words, const Unpacker& unpack) {
  if (unpack.absurd() <= unpack.plausible()) return;
  file.Refuse(variable,
              "most values are impossible for " + std::string(words.name) +
                  ", expected " + std::to_string(words.least) + " to " +
                  std::to_string(words.most) + " " + words.units.front().name);
}

bool IsWindName(const std::string& standard_name) {
  return standard_name == "eastward_wind" || standard_name == "northward_wind";
}

// One component of water's velocity and one of the wind's are no field.
void RefuseTwoMedia(const NetcdfFile& file,
                    const std::vector<const NetcdfVariable*>& variables) {
  if (variables.size() < 2) return;
  const std::string first = variables[0]->Text("standard_name");
  const std::string second = variables[1]->Text("standard_name");
  if (IsWindName(first) == IsWindName(second)) return;
  file.Refuse("variables " + variables[0]->name + " (" + first + ") and " +
              variables[1]->name + " (" + second +
              "): expected both of sea water or both of wind");
}

}  // namespace

bool IsWind(const QuantitySeries& series) {
  return IsWindName(series.standard_name);
}

const char* Name(FieldQuantity quantity) { return VocabularyOf(quantity).name; }

std::vector<const NetcdfVariable*> FindVariables(
    const NetcdfFile& file, const std::vector<FieldQuantity>& quantities) {
  std::vector<const NetcdfVariable*> variables;
  std::string missing;
  for (const FieldQuantity quantity : quantities) {
    const Vocabulary& words = VocabularyOf(quantity);
    variables.push_back(FindVariable(file, words));
    if (variables.back() != nullptr) continue;
    missing += std::string(missing.empty() ? "" : "; ") + "no variable for " +
               words.name + ", tried standard_name " +
               Join(words.standard_names) + " and name " +
               Join(words.variable_names);
  }
  if (!missing.empty()) file.Refuse(missing);
  RefuseTwoMedia(file, variables);
  return variables;
}

QuantitySeries ReadSeries(const NetcdfFile& file, const FieldAxes& axes,
                          const NetcdfVariable& variable,
                          FieldQuantity quantity) {
  const Vocabulary words = WordsFor(quantity, variable);
  Unpacker unpack(file, variable, words);
  QuantitySeries series{
      quantity, variable.name, variable.Text("standard_name"), {}};
  std::vector<std::size_t> empty_times;
  for (std::size_t time = 0; time < axes.time_s.size(); ++time) {
    const std::size_t before = unpack.plausible();
    const std::vector<double> raw = RawSlice(file, axes, variable, time);
    series.at_time.push_back(Canonical(axes, raw, &unpack));
    if (unpack.plausible() == before) empty_times.push_back(time);
  }
  if (quantity == FieldQuantity::kAny) return series;
  RefuseAbsurd(file, variable, words, unpack);
  if (!empty_times.empty()) {
    file.Refuse(variable, "no value in any cell at time " +
                              std::to_string(empty_times.front()) +
                              ", expected some");
  }
  return series;
}

}  // namespace kg_core
