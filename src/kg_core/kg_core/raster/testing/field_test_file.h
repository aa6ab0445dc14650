// For tests: writes small ocean files of every shape, and finds the real ones.

#ifndef KG_CORE_RASTER_TESTING_FIELD_TEST_FILE_H_
#define KG_CORE_RASTER_TESTING_FIELD_TEST_FILE_H_

#include <gtest/gtest.h>
#include <netcdf.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "kg_core/base/input_error.h"
#include "kg_core/raster/field_file.h"

namespace kg_core {

enum class Fill { kAttribute, kFloatAttribute, kMissingValue, kDefault, kNan };

// What to write. The defaults are a plain HYCOM-like file.
struct TestFile {
  int format = 0;              // NC_64BIT_OFFSET, NC_64BIT_DATA, NC_NETCDF4.
  std::string order = "tzyx";  // Of the variables' dimensions; t, z at will.
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
  double speed_factor = 1.0;  // Written = m/s times this.
  std::string east_name = "water_u";
  std::string east_standard = "eastward_sea_water_velocity";
  bool north = true;
  std::string north_standard = "northward_sea_water_velocity";
  bool coordinate_attributes = true;
  bool curvilinear = false;
  bool all_land = false;
  double odd_value = NAN;  // In the north-eastern cell of the first time.
  double all_value = NAN;
  std::map<std::string, double> east_numbers;  // More attributes.
};

inline bool TestLand(double lon, double lat) {
  return std::abs(lat - 21.0) < 1e-6 && std::abs(lon + 98.0) < 1e-6;
}
// Another value for every longitude, latitude, time and depth, at most 2 m/s.
inline double TestSpeed(double lon, double lat, double hours, double depth) {
  const double speed = std::sin(7.0 * lon) + 0.5 * std::sin(11.0 * lat) +
                       0.3 * std::sin(hours) + 0.2 * std::sin(depth);
  return std::isfinite(speed) ? std::round(1000.0 * speed) / 1000.0 : 0.0;
}

class TestFileWriter {
 public:
  TestFileWriter(const std::string& path, const TestFile& spec) : spec_(spec) {
    Check(nc_create(path.c_str(), NC_CLOBBER | spec.format, &nc_));
    DefineAxes();
    const int east = DefineSpeed(spec.east_name, spec.east_standard);
    for (const auto& number : spec.east_numbers) {
      Check(nc_put_att_double(nc_, east, number.first.c_str(), NC_DOUBLE, 1,
                              &number.second));
    }
    const int north =
        spec.north ? DefineSpeed("water_v", spec.north_standard) : -1;
    Check(nc_enddef(nc_));
    PutAxes();
    PutSpeed(east, 1.0);
    if (spec.north) PutSpeed(north, -1.0);
    Check(nc_close(nc_));
  }

 private:
  static void Check(int status) {
    ASSERT_EQ(status, NC_NOERR) << nc_strerror(status);
  }
  void Text(int variable, const char* name, const std::string& text) {
    Check(nc_put_att_text(nc_, variable, name, text.size(), text.c_str()));
  }
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
      Check(nc_def_dim(nc_, names.at(axis).c_str(),
                       unlimited ? NC_UNLIMITED : Axis(axis).size(),
                       &dims_[axis]));
    }
    for (const char axis : {'t', 'z', 'y', 'x'}) {
      const bool scalar = dims_.count(axis) == 0;
      if (scalar && axis != 't') continue;
      std::vector<int> on{scalar ? 0 : dims_[axis]};
      if (spec_.curvilinear && (axis == 'y' || axis == 'x')) {
        on = {dims_['y'], dims_['x']};
      }
      const bool renamed = spec_.curvilinear && axis != 't' && axis != 'z';
      Check(nc_def_var(nc_, (names.at(axis) + (renamed ? "2" : "")).c_str(),
                       NC_DOUBLE, scalar ? 0 : static_cast<int>(on.size()),
                       on.data(), &vars_[axis]));
    }
    Text(vars_['t'], "units", spec_.time_units);
    if (!spec_.calendar.empty()) Text(vars_['t'], "calendar", spec_.calendar);
    if (!spec_.coordinate_attributes) return;
    Text(vars_['y'], "units", "degrees_north");
    Text(vars_['x'], "units", "degrees_east");
    if (dims_.count('z') > 0) Text(vars_['z'], "positive", "down");
  }
  int DefineSpeed(const std::string& name, const std::string& standard) {
    std::vector<int> on;
    for (const char axis : spec_.order) on.push_back(dims_[axis]);
    int variable = -1;
    Check(nc_def_var(nc_, name.c_str(), spec_.packed ? NC_SHORT : NC_FLOAT,
                     static_cast<int>(on.size()), on.data(), &variable));
    if (!standard.empty()) Text(variable, "standard_name", standard);
    if (!spec_.speed_units.empty()) Text(variable, "units", spec_.speed_units);
    const float scale = 0.001f;
    if (spec_.packed) {
      Check(
          nc_put_att_float(nc_, variable, "scale_factor", NC_FLOAT, 1, &scale));
    }
    DefineFill(variable);
    return variable;
  }
  void DefineFill(int variable) {
    const double fill = RawFill();
    const short packed = static_cast<short>(fill);
    if (spec_.fill == Fill::kAttribute && spec_.packed) {
      Check(
          nc_put_att_short(nc_, variable, "_FillValue", NC_SHORT, 1, &packed));
    } else if (spec_.fill == Fill::kAttribute) {
      Check(nc_put_att_double(nc_, variable, "_FillValue", NC_FLOAT, 1, &fill));
    } else if (spec_.fill == Fill::kFloatAttribute ||
               spec_.fill == Fill::kMissingValue) {
      // The library insists on the own type for _FillValue, not for this one.
      Check(nc_put_att_double(
          nc_, variable, "missing_value",
          spec_.fill == Fill::kMissingValue ? NC_DOUBLE : NC_FLOAT, 1, &fill));
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
      const std::vector<std::size_t> start(2, 0);
      std::vector<std::size_t> count{values.size()};
      if (spread) count = {spec_.lat.size(), spec_.lon.size()};
      Check(nc_put_vara_double(nc_, vars_[axis], start.data(), count.data(),
                               values.data()));
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
  void PutSpeed(int variable, double sign) {
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
      Check(
          nc_put_vara_double(nc_, variable, start.data(), count.data(), &raw));
    }
  }

  const TestFile& spec_;
  int nc_ = -1;
  std::map<char, int> dims_;
  std::map<char, int> vars_;
};

// A file in a folder of its own; both gone afterwards.
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

// The error's text; "read" when there is none.
template <typename Function>
std::string InputErrorOf(const Function& function) {
  try {
    function();
  } catch (const InputError& error) {
    return error.what();
  }
  return "read";
}

// The path of a real data file; "" where it is not there.
inline std::string SharedData(const std::string& name) {
  const char* folder = std::getenv("KG_SHARED_DATA");
  // Tests run in the package's folder, src/kg_core.
  const std::string path =
      std::string(folder != nullptr ? folder : "../../../shared/data") + "/" +
      name;
  return std::ifstream(path) ? path : "";
}

}  // namespace kg_core

#endif  // KG_CORE_RASTER_TESTING_FIELD_TEST_FILE_H_
