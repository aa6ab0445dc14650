#include "kg_base/raster/read_field_file.h"

#include <cmath>
#include <stdexcept>

#include "kg_base/common/join_strings.h"
#include "kg_base/common/sha256.h"
#include "kg_base/raster/field_axes.h"
#include "kg_base/raster/field_protocol.h"
#include "kg_base/raster/field_values.h"
#include "kg_base/raster/find_variables.h"
#include "kg_base/raster/netcdf_file.h"

namespace kg_base {
namespace {

constexpr double kTimeTolerance = 0.01;  // In time steps.
constexpr double kSingleStep_s = 3600.0;

void CheckSize(const NetcdfFile& file, const FieldFile& read,
               std::size_t quantities) {
  const double values = static_cast<double>(read.grid.size()) *
                        static_cast<double>(read.time_s.size()) *
                        static_cast<double>(quantities);
  if (values > static_cast<double>(kMaxFieldValues)) {
    file.Refuse("expected at most " + std::to_string(kMaxFieldValues) +
                " values in all");
  }
}

// Times of two precisions differ by rounding.
bool AlmostSameTimes(const std::vector<double>& a,
                     const std::vector<double>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double step = i > 0 ? a[i] - a[i - 1] : kSingleStep_s;
    if (!(std::abs(a[i] - b[i]) <= kTimeTolerance * step)) return false;
  }
  return true;
}

void CheckSameAxes(const NetcdfFile& file, const FieldAxes& axes,
                   const FieldFile& read, const NetcdfVariable& variable) {
  if (axes.grid.AlmostEquals(read.grid) &&
      AlmostSameTimes(read.time_s, axes.time_s)) {
    return;
  }
  file.Refuse(variable, "expected the grid and the times of variable " +
                            read.series.front().variable +
                            "; components of staggered grids must be "
                            "interpolated to one grid");
}

const NetcdfVariable& VariableNamed(const NetcdfFile& file,
                                    const std::string& name) {
  std::vector<std::string> names;  // Names of possible fields.
  for (const NetcdfVariable& variable : file.variables()) {
    if (variable.name == name) return variable;
    if (variable.dimensions.size() >= 2) names.push_back(variable.name);
  }
  file.Refuse("no variable \"" + name + "\", expected one of " +
              (names.empty() ? "none: it has no fields" : JoinStrings(names)));
}

}  // namespace

FieldFile ReadFieldFile(const std::string& path,
                        const std::vector<FieldQuantity>& quantities) {
  if (quantities.empty()) throw std::logic_error("no quantity is asked for");
  const NetcdfFile file(path);
  const std::vector<FoundVariable> found = FindVariables(file, quantities);
  FieldFile read;
  read.path = path;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const NetcdfVariable& variable = *found[i].variable;
    const FieldAxes axes = ReadFieldAxes(file, variable);
    // The first variable sets grid and times; the others must agree.
    if (i == 0) {
      read.grid = axes.grid;
      read.time_s = axes.time_s;
      CheckSize(file, read, found.size());
    } else {
      CheckSameAxes(file, axes, read, variable);
    }
    read.series.push_back(ReadSeries(file, axes, variable, quantities[i]));
    std::vector<std::string>& warnings = read.series.back().report.warnings;
    warnings.insert(warnings.begin(), found[i].warnings.begin(),
                    found[i].warnings.end());
  }
  read.sha256 = Sha256HexOfFile(path);
  return read;
}

FieldFile ReadVariable(const std::string& path, const std::string& variable) {
  const NetcdfFile file(path);
  const NetcdfVariable& found = VariableNamed(file, variable);
  const FieldAxes axes = ReadFieldAxes(file, found, TimeAxis::kOptional);
  FieldFile read;
  read.path = path;
  read.grid = axes.grid;
  read.time_s = axes.time_s;
  CheckSize(file, read, 1);
  read.series.push_back(ReadSeries(file, axes, found, FieldQuantity::kAny));
  read.sha256 = Sha256HexOfFile(path);
  return read;
}

}  // namespace kg_base
