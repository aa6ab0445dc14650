// For tests: writes NetCDF files with any variables on one grid.

#ifndef KG_BASE_RASTER_TESTING_TEST_RASTER_FILE_H_
#define KG_BASE_RASTER_TESTING_TEST_RASTER_FILE_H_

#include <cmath>
#include <netcdf>
#include <string>
#include <vector>

#include "kg_base/raster/grid.h"

namespace kg_base {

struct TestVariable {
  std::string name;
  std::string standard_name;  // "" = no standard_name and no units.
  std::string units;
  std::vector<Raster> steps;  // NaN = no data.
  bool has_time = true;       // false: only the first step is written.
};

struct TestRasterFile {
  Grid grid;
  std::vector<double> hours;  // Hours since 2026-06-01 00:00.
  std::vector<TestVariable> variables;
};

class TestRasterFileWriter {
 public:
  TestRasterFileWriter(const std::string& path, const TestRasterFile& file) {
    nc_.create(path, NC_CLOBBER);
    const netCDF::NcVar time =
        Axis("time", "hours since 2026-06-01 00:00:00", file.hours);
    const netCDF::NcVar lat = Axis("lat", "degrees_north", file.grid.lat_deg());
    const netCDF::NcVar lon = Axis("lon", "degrees_east", file.grid.lon_deg());
    std::vector<netCDF::NcVar> fields;
    for (const TestVariable& v : file.variables) fields.push_back(Define(v));
    nc_.enddef();
    if (!time.isNull()) time.putVar(file.hours.data());
    lat.putVar(file.grid.lat_deg().data());
    lon.putVar(file.grid.lon_deg().data());
    for (std::size_t i = 0; i < fields.size(); ++i) {
      fields[i].putVar(Values(file.variables[i]).data());
    }
    nc_.close();
  }

 private:
  static constexpr float kFill = 1e30f;

  // Adds an axis; without values neither variable nor dimension.
  netCDF::NcVar Axis(const std::string& name, const std::string& units,
                     const std::vector<double>& values) {
    if (values.empty()) return {};
    dims_.push_back(nc_.addDim(name, values.size()));
    const netCDF::NcVar axis = nc_.addVar(name, netCDF::ncDouble, dims_.back());
    axis.putAtt("units", units);
    return axis;
  }
  netCDF::NcVar Define(const TestVariable& variable) {
    // Latitude and longitude are the last two dimensions, after time.
    const auto first = variable.has_time ? dims_.begin() : dims_.end() - 2;
    const netCDF::NcVar field =
        nc_.addVar(variable.name, netCDF::ncFloat,
                   std::vector<netCDF::NcDim>(first, dims_.end()));
    field.putAtt("_FillValue", netCDF::ncFloat, kFill);
    if (variable.standard_name.empty()) return field;
    field.putAtt("standard_name", variable.standard_name);
    field.putAtt("units", variable.units);
    return field;
  }
  static std::vector<double> Values(const TestVariable& variable) {
    std::vector<double> values;
    for (const Raster& step : variable.steps) {
      for (const float v : step) values.push_back(std::isnan(v) ? kFill : v);
      if (!variable.has_time) break;
    }
    return values;
  }

  netCDF::NcFile nc_;
  std::vector<netCDF::NcDim> dims_;
};

}  // namespace kg_base

#endif  // KG_BASE_RASTER_TESTING_TEST_RASTER_FILE_H_
