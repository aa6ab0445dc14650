#include "kg_base/raster/read_field_file.h"

#include <stdexcept>

#include "kg_base/common/join_strings.h"
#include "kg_base/common/sha256.h"
#include "kg_base/raster/field_axes.h"
#include "kg_base/raster/field_protocol.h"
#include "kg_base/raster/field_values.h"
#include "kg_base/raster/netcdf_file.h"

namespace kg_base {
namespace {

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

void CheckSameAxes(const NetcdfFile& file, const FieldAxes& axes,
                   const FieldFile& read, const NetcdfVariable& variable) {
  if (axes.grid == read.grid && axes.time_s == read.time_s) return;
  file.Refuse(variable, "expected the grid and the times of variable " +
                            read.series.front().variable);
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
  const std::vector<const NetcdfVariable*> variables =
      FindVariables(file, quantities);
  FieldFile read;
  read.path = path;
  for (std::size_t i = 0; i < variables.size(); ++i) {
    const FieldAxes axes = ReadFieldAxes(file, *variables[i]);
    // The first variable sets grid and times; the others must agree.
    if (i == 0) {
      read.grid = axes.grid;
      read.time_s = axes.time_s;
      CheckSize(file, read, variables.size());
    } else {
      CheckSameAxes(file, axes, read, *variables[i]);
    }
    read.series.push_back(ReadSeries(file, axes, *variables[i], quantities[i]));
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
