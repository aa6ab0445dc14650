// For tests: writes small gridded files of every shape, and locates the real
// ones.

#ifndef KG_BASE_RASTER_TESTING_FIELD_TEST_FILE_H_
#define KG_BASE_RASTER_TESTING_FIELD_TEST_FILE_H_

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <netcdf>
#include <sstream>
#include <string>
#include <vector>

#include "kg_base/common/input_error.h"
#include "kg_base/raster/read_field_file.h"

namespace kg_base {

enum class Fill { kAttribute, kFloatAttribute, kMissingValue, kDefault, kNan };

// Contents to write. The defaults are a plain HYCOM-like file.
struct TestFile {
  int format = 0;              // NC_64BIT_OFFSET, NC_64BIT_DATA, NC_NETCDF4.
  std::string order = "tzyx";  // Order of dimensions; t and z are optional.
  std::vector<double> lon{-98, -97.9, -97.8, -97.7};
  std::vector<double> lat{21, 21.1, 21.25};
  std::vector<double> depth{0, 10};
  std::vector<double> time{10, 15, 20};
  bool records = false;  // Is time the unlimited dimension?
  bool packed = true;
  Fill fill = Fill::kAttribute;
  std::string lon_name = "lon";
  std::string lat_name = "lat";
  std::string time_units = "hours since 2000-01-01 00:00:00";
  std::string calendar = "standard";
  std::string speed_units = "m/s";
  double speed_factor = 1.0;  // Written value = m/s * speed_factor.
  std::string east_name = "water_u";
  std::string east_standard = "eastward_sea_water_velocity";
  bool north = true;
  std::string north_standard = "northward_sea_water_velocity";
  bool coordinate_attributes = true;
  bool curvilinear = false;
  bool all_land = false;
  double odd_value = NAN;  // Value in the north-eastern cell, first time.
  double all_value = NAN;
  std::map<std::string, double> east_numbers;  // More attributes.
};

inline bool TestLand(double lon, double lat) {
  return std::abs(lat - 21.0) < 1e-6 && std::abs(lon + 98.0) < 1e-6;
}
// Distinct speed for every longitude, latitude, time and depth, at most 2 m/s.
inline double TestSpeed(double lon, double lat, double hours, double depth) {
  const double speed = std::sin(7.0 * lon) + 0.5 * std::sin(11.0 * lat) +
                       0.3 * std::sin(hours) + 0.2 * std::sin(depth);
  return std::isfinite(speed) ? std::round(1000.0 * speed) / 1000.0 : 0.0;
}

class TestFileWriter {
 public:
  TestFileWriter(const std::string& path, const TestFile& spec) : spec_(spec) {
    nc_.create(path, NC_CLOBBER | spec.format);
    DefineAxes();
    const netCDF::NcVar east = DefineSpeed(spec.east_name, spec.east_standard);
    for (const auto& number : spec.east_numbers) {
      east.putAtt(number.first, netCDF::ncDouble, number.second);
    }
    netCDF::NcVar north;
    if (spec.north) north = DefineSpeed("water_v", spec.north_standard);
    nc_.enddef();
    PutAxes();
    PutSpeed(east, 1.0);
    if (spec.north) PutSpeed(north, -1.0);
    nc_.close();
  }

 private:
  const std::vector<double>& Axis(char axis) const {
    return axis == 't'   ? spec_.time
           : axis == 'z' ? spec_.depth
           : axis == 'y' ? spec_.lat
                         : spec_.lon;
  }
  void DefineAxes() {
    const std::map<char, std::string> names{{'t', "time"},
                                            {'z', "depth"},
                                            {'y', spec_.lat_name},
                                            {'x', spec_.lon_name}};
    for (const char axis : spec_.order) {
      const bool unlimited = axis == 't' && spec_.records;
      dims_[axis] = nc_.addDim(names.at(axis),
                               unlimited ? NC_UNLIMITED : Axis(axis).size());
    }
    for (const char axis : {'t', 'z', 'y', 'x'}) {
      const bool scalar = dims_.count(axis) == 0;
      if (scalar && axis != 't') continue;
      std::vector<netCDF::NcDim> on;
      if (!scalar) on = {dims_[axis]};
      if (spec_.curvilinear && (axis == 'y' || axis == 'x')) {
        on = {dims_['y'], dims_['x']};
      }
      const bool renamed = spec_.curvilinear && axis != 't' && axis != 'z';
      vars_[axis] = nc_.addVar(names.at(axis) + (renamed ? "2" : ""),
                               netCDF::ncDouble, on);
    }
    vars_['t'].putAtt("units", spec_.time_units);
    if (!spec_.calendar.empty()) vars_['t'].putAtt("calendar", spec_.calendar);
    if (!spec_.coordinate_attributes) return;
    vars_['y'].putAtt("units", "degrees_north");
    vars_['x'].putAtt("units", "degrees_east");
    if (dims_.count('z') > 0) vars_['z'].putAtt("positive", "down");
  }
  netCDF::NcVar DefineSpeed(const std::string& name,
                            const std::string& standard) {
    std::vector<netCDF::NcDim> on;
    for (const char axis : spec_.order) on.push_back(dims_[axis]);
    const netCDF::NcType type(spec_.packed ? NC_SHORT : NC_FLOAT);
    const netCDF::NcVar variable = nc_.addVar(name, type, on);
    if (!standard.empty()) variable.putAtt("standard_name", standard);
    if (!spec_.speed_units.empty()) {
      variable.putAtt("units", spec_.speed_units);
    }
    if (spec_.packed) variable.putAtt("scale_factor", netCDF::ncFloat, 0.001f);
    DefineFill(variable);
    return variable;
  }
  void DefineFill(const netCDF::NcVar& variable) {
    const double fill = RawFill();
    if (spec_.fill == Fill::kAttribute && spec_.packed) {
      variable.putAtt("_FillValue", netCDF::ncShort, static_cast<short>(fill));
    } else if (spec_.fill == Fill::kAttribute) {
      variable.putAtt("_FillValue", netCDF::ncFloat, fill);
    } else if (spec_.fill == Fill::kFloatAttribute) {
      // The library requires the variable's type for _FillValue, but not for
      // missing_value.
      variable.putAtt("missing_value", netCDF::ncFloat, fill);
    } else if (spec_.fill == Fill::kMissingValue) {
      variable.putAtt("missing_value", netCDF::ncDouble, fill);
    }
  }
  double RawFill() const {
    if (spec_.fill == Fill::kNan) return NAN;
    if (spec_.fill == Fill::kDefault) {
      return spec_.packed ? NC_FILL_SHORT : NC_FILL_FLOAT;
    }
    return spec_.packed ? -30000 : 1.2676506e30;
  }
  void PutAxes() {
    for (const char axis : {'t', 'z', 'y', 'x'}) {
      if (vars_.count(axis) == 0) continue;
      std::vector<double> values = Axis(axis);
      const bool spread = spec_.curvilinear && (axis == 'y' || axis == 'x');
      if (spread) values.resize(spec_.lat.size() * spec_.lon.size(), 0.0);
      // Use start and count: an unlimited time has no length until it is
      // written, and a scalar has no index.
      std::vector<std::size_t> count{values.size()};
      if (spread) count = {spec_.lat.size(), spec_.lon.size()};
      const std::vector<std::size_t> start(count.size(), 0);
      if (vars_[axis].getDimCount() == 0) {
        vars_[axis].putVar(values.data());
      } else {
        vars_[axis].putVar(start, count, values.data());
      }
    }
  }
  double Raw(double sign, const std::map<char, double>& at, bool first) const {
    const double lon = at.at('x') > 180 ? at.at('x') - 360 : at.at('x');
    const double lat = at.at('y');
    if (spec_.all_land || TestLand(lon, lat)) return RawFill();
    double value = sign * TestSpeed(lon, lat, at.at('t'), at.at('z'));
    if (first && !std::isnan(spec_.odd_value)) value = spec_.odd_value;
    if (!std::isnan(spec_.all_value)) value = spec_.all_value;
    value *= spec_.speed_factor;
    return spec_.packed ? std::round(value * 1000) : value;
  }
  void PutSpeed(const netCDF::NcVar& variable, double sign) {
    std::vector<std::size_t> start(spec_.order.size(), 0);
    std::vector<std::size_t> count(spec_.order.size(), 1);
    std::size_t total = 1;
    for (const char axis : spec_.order) total *= Axis(axis).size();
    for (std::size_t i = 0; i < total; ++i) {
      std::map<char, double> at{{'t', spec_.time[0]}, {'z', spec_.depth[0]}};
      std::size_t rest = i;
      bool first = true;
      for (std::size_t d = spec_.order.size(); d-- > 0;) {
        const std::vector<double>& axis = Axis(spec_.order[d]);
        start[d] = rest % axis.size();
        rest /= axis.size();
        at[spec_.order[d]] = axis[start[d]];
        const char kind = spec_.order[d];
        const std::size_t wanted =
            kind == 'x' || kind == 'y' ? axis.size() - 1 : 0;
        first = first && start[d] == wanted;
      }
      const double raw = Raw(sign, at, first);
      variable.putVar(start, count, &raw);
    }
  }

  const TestFile& spec_;
  netCDF::NcFile nc_;
  std::map<char, netCDF::NcDim> dims_;
  std::map<char, netCDF::NcVar> vars_;
};

// A file in a temporary folder; both are removed by the destructor.
class TempFile {
 public:
  TempFile() {
    char folder[] = "/tmp/kg_field_XXXXXX";
    folder_ = mkdtemp(folder);
    path_ = folder_ + "/file.nc";
  }
  explicit TempFile(const TestFile& spec) : TempFile() {
    TestFileWriter(path_, spec);
  }
  ~TempFile() {
    unlink(path_.c_str());
    rmdir(folder_.c_str());
  }
  TempFile(const TempFile&) = delete;
  TempFile& operator=(const TempFile&) = delete;

  const std::string& path() const { return path_; }
  std::string Bytes() const {
    std::stringstream bytes;
    bytes << std::ifstream(path_, std::ios::binary).rdbuf();
    return bytes.str();
  }
  void Write(const std::string& bytes) const {
    std::ofstream(path_, std::ios::binary | std::ios::trunc) << bytes;
  }

 private:
  std::string folder_;
  std::string path_;
};

inline const std::vector<FieldQuantity>& BothVelocities() {
  static const std::vector<FieldQuantity> kBoth{
      FieldQuantity::kEastwardVelocity, FieldQuantity::kNorthwardVelocity};
  return kBoth;
}

// The error text; "read" if there is none.
template <typename Function>
std::string InputErrorOf(const Function& function) {
  try {
    function();
  } catch (const InputError& error) {
    return error.what();
  }
  return "read";
}

// The path of a real data file; "" if it is not present.
inline std::string SharedData(const std::string& name) {
  const char* folder = std::getenv("KG_SHARED_DATA");
  // Tests run in the package's folder, src/kg_base.
  const std::string path =
      std::string(folder != nullptr ? folder : "../../../shared/data") + "/" +
      name;
  return std::ifstream(path) ? path : "";
}

}  // namespace kg_base

#endif  // KG_BASE_RASTER_TESTING_FIELD_TEST_FILE_H_
