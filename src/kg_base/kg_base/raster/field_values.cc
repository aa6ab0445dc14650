#include "kg_base/raster/field_values.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "kg_base/common/join_strings.h"
#include "kg_base/common/text.h"
#include "kg_base/raster/field_quantity.h"

namespace kg_base {
namespace {

constexpr float kNoData = std::numeric_limits<float>::quiet_NaN();

// The variable with a standard name; of several the one with a usual name.
const NetcdfVariable* ByStandardName(const NetcdfFile& file,
                                     const QuantityWords& words,
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
              ", expected one, or one named " +
              JoinStrings(words.variable_names));
}

const NetcdfVariable* FindVariable(const NetcdfFile& file,
                                   const QuantityWords& words) {
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
                  const QuantityWords& words) {
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

// The library's default fill for unwritten values. Bytes have none because
// every value is valid.
std::vector<double> DefaultFill(int type) {
  switch (type) {
    case netCDF::NcType::nc_SHORT:
      return {NC_FILL_SHORT};
    case netCDF::NcType::nc_USHORT:
      return {NC_FILL_USHORT};
    case netCDF::NcType::nc_INT:
      return {NC_FILL_INT};
    case netCDF::NcType::nc_UINT:
      return {NC_FILL_UINT};
    case netCDF::NcType::nc_FLOAT:
    case netCDF::NcType::nc_DOUBLE:
      return {NC_FILL_DOUBLE};
    default:
      return {};
  }
}

class ValueUnpacker {
 public:
  ValueUnpacker(const NetcdfFile& file, const NetcdfVariable& variable,
                const QuantityWords& words)
      : is_float_(variable.type == netCDF::NcType::nc_FLOAT),
        min_(words.min_value),
        max_(words.max_value) {
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

  // Converts a raw value to SI or NaN, and updates the counters.
  float operator()(double raw) {
    if (!std::isfinite(raw) || IsFill(raw)) return kNoData;
    const double value = raw * scale_ + offset_;
    if (value >= min_ && value <= max_) {
      ++plausible_;
      return static_cast<float>(value);
    }
    ++absurd_;
    return kNoData;
  }
  std::size_t plausible() const { return plausible_; }
  std::size_t absurd() const { return absurd_; }

 private:
  // The fill of a float variable may be written as a double: compare both in
  // the variable's type.
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
  double min_;
  double max_;
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
                 ValueUnpacker* unpack) {
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
                  const QuantityWords& words, const ValueUnpacker& unpack) {
  if (unpack.absurd() <= unpack.plausible()) return;
  file.Refuse(variable, "most values are impossible for " +
                            std::string(words.name) + ", expected " +
                            std::to_string(words.min_value) + " to " +
                            std::to_string(words.max_value) + " " +
                            words.units.front().name);
}

// Rejects one component of water velocity combined with one of wind velocity.
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

std::vector<const NetcdfVariable*> FindVariables(
    const NetcdfFile& file, const std::vector<FieldQuantity>& quantities) {
  std::vector<const NetcdfVariable*> variables;
  std::vector<std::string> missing;
  for (const FieldQuantity quantity : quantities) {
    const QuantityWords& words = WordsFor(quantity);
    variables.push_back(FindVariable(file, words));
    if (variables.back() != nullptr) continue;
    missing.push_back("no variable for " + std::string(words.name) +
                      ", tried standard_name " +
                      JoinStrings(words.standard_names) + " and name " +
                      JoinStrings(words.variable_names));
  }
  if (!missing.empty()) file.Refuse(JoinStrings(missing, "; "));
  RefuseTwoMedia(file, variables);
  return variables;
}

QuantitySeries ReadSeries(const NetcdfFile& file, const FieldAxes& axes,
                          const NetcdfVariable& variable,
                          FieldQuantity quantity) {
  const QuantityWords words =
      WordsFor(quantity, variable.Text("standard_name"));
  ValueUnpacker unpack(file, variable, words);
  QuantitySeries series{
      quantity, variable.name, variable.Text("standard_name"), {}};
  std::vector<std::size_t> empty_times;
  for (std::size_t time = 0; time < axes.time_s.size(); ++time) {
    const std::size_t before = unpack.plausible();
    const std::vector<double> raw = RawSlice(file, axes, variable, time);
    series.at_time.push_back(Canonical(axes, raw, &unpack));
    // A time is empty if it added no plausible value.
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

}  // namespace kg_base
