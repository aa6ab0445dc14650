// For tests: writes NetCDF files of any variables on one grid.

#ifndef KG_CORE_RASTER_TESTING_TEST_RASTER_FILE_H_
#define KG_CORE_RASTER_TESTING_TEST_RASTER_FILE_H_

#include <netcdf.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "kg_core/raster/grid.h"

namespace kg_core {

struct TestVariable {
  std::string name;
  std::string standard_name;  // "": none, and no units.
  std::string units;
  std::vector<Raster> steps;  // NaN = no data.
  bool has_time = true;       // Else the first step is all there is.
};

struct TestRasterFile {
  Grid grid;
  std::vector<double> hours;  // Since 2026-06-01 00:00.
  std::vector<TestVariable> variables;
};

class TestRasterFileWriter {
 public:
  TestRasterFileWriter(const std::string& path, const TestRasterFile& file) {
    Check(nc_create(path.c_str(), NC_CLOBBER, &nc_));
    const int time =
        Axis("time", "hours since 2026-06-01 00:00:00", file.hours);
    const int lat = Axis("lat", "degrees_north", file.grid.lat_deg());
    const int lon = Axis("lon", "degrees_east", file.grid.lon_deg());
    std::vector<int> ids;
    for (const TestVariable& v : file.variables) ids.push_back(Define(v));
    Check(nc_enddef(nc_));
    if (time >= 0) Put(time, file.hours);
    Put(lat, file.grid.lat_deg());
    Put(lon, file.grid.lon_deg());
    for (std::size_t i = 0; i < ids.size(); ++i) {
      Put(ids[i], Values(file.variables[i]));
    }
    Check(nc_close(nc_));
  }

 private:
  static constexpr float kFill = 1e30f;

  static void Check(int status) {
    if (status != NC_NOERR) throw std::runtime_error(nc_strerror(status));
  }
  void Text(int id, const char* name, const std::string& text) {
    Check(nc_put_att_text(nc_, id, name, text.size(), text.c_str()));
  }
  int Axis(const char* name, const std::string& units,
           const std::vector<double>& values) {
    dims_.push_back(-1);
    if (values.empty()) return -1;
    int id = 0;
    Check(nc_def_dim(nc_, name, values.size(), &dims_.back()));
    Check(nc_def_var(nc_, name, NC_DOUBLE, 1, &dims_.back(), &id));
    Text(id, "units", units);
    return id;
  }
  int Define(const TestVariable& variable) {
    int id = 0;
    const int first = variable.has_time ? 0 : 1;
    Check(nc_def_var(nc_, variable.name.c_str(), NC_FLOAT, 3 - first,
                     dims_.data() + first, &id));
    Check(nc_put_att_float(nc_, id, "_FillValue", NC_FLOAT, 1, &kFill));
    if (variable.standard_name.empty()) return id;
    Text(id, "standard_name", variable.standard_name);
    Text(id, "units", variable.units);
    return id;
  }
  static std::vector<double> Values(const TestVariable& variable) {
    std::vector<double> values;
    for (const Raster& step : variable.steps) {
      for (const float v : step) values.push_back(std::isnan(v) ? kFill : v);
      if (!variable.has_time) break;
    }
    return values;
  }
  void Put(int id, const std::vector<double>& values) {
    Check(nc_put_var_double(nc_, id, values.data()));
  }

  int nc_ = 0;
  std::vector<int> dims_;  // Time (-1: none), latitude, longitude.
};

}  // namespace kg_core

#endif  // KG_CORE_RASTER_TESTING_TEST_RASTER_FILE_H_
