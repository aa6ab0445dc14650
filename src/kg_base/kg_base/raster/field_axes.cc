#include "kg_base/raster/field_axes.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "kg_base/common/input_error.h"
#include "kg_base/common/text.h"
#include "kg_base/raster/cf_time.h"

namespace kg_base {
namespace {

constexpr std::size_t kMaxCoordinates = 100000;
// A gap above this multiple of the widest spacing is not the seam of a global
// grid.
constexpr double kSeamFactor = 1.5;

enum class AxisRole { kUnknown, kTime, kDepth, kLatitude, kLongitude };

bool IsOneOf(const std::string& text, std::initializer_list<const char*> list) {
  return std::find(list.begin(), list.end(), text) != list.end();
}

AxisRole RoleByAttributes(const NetcdfVariable& variable) {
  const std::string standard = variable.Text("standard_name");
  const std::string units = variable.Text("units");
  // All spellings that CF allows (4.1, 4.2); plain "degrees" is ambiguous.
  if (standard == "latitude" ||
      IsOneOf(units, {"degrees_north", "degree_north", "degrees_N", "degree_N",
                      "degreesN", "degreeN"})) {
    return AxisRole::kLatitude;
  }
  if (standard == "longitude" ||
      IsOneOf(units, {"degrees_east", "degree_east", "degrees_E", "degree_E",
                      "degreesE", "degreeE"})) {
    return AxisRole::kLongitude;
  }
  if (standard == "time" || units.find(" since ") != std::string::npos) {
    return AxisRole::kTime;
  }
  const std::string positive = ToLowerAscii(variable.Text("positive"));
  if (standard == "depth" || variable.Text("axis") == "Z" ||
      positive == "down" || positive == "up") {
    return AxisRole::kDepth;
  }
  return AxisRole::kUnknown;
}

AxisRole RoleByName(const std::string& any_case) {
  const std::string name = ToLowerAscii(any_case);
  if (IsOneOf(name, {"lat", "latitude", "nav_lat"})) return AxisRole::kLatitude;
  if (IsOneOf(name, {"lon", "longitude", "nav_lon"}))
    return AxisRole::kLongitude;
  if (IsOneOf(name, {"time", "mt", "t", "ocean_time"})) return AxisRole::kTime;
  if (IsOneOf(name, {"depth", "lev", "level", "deptht", "z", "layer"})) {
    return AxisRole::kDepth;
  }
  return AxisRole::kUnknown;
}

// Role by attributes; by name only if no attribute identifies the quantity.
AxisRole RoleOf(const NetcdfVariable& variable) {
  const AxisRole role = RoleByAttributes(variable);
  if (role != AxisRole::kUnknown) return role;
  if (!variable.Text("standard_name").empty()) return AxisRole::kUnknown;
  return RoleByName(variable.name);
}

class AxesReader {
 public:
  AxesReader(const NetcdfFile& file, const NetcdfVariable& variable,
             TimeAxis need_of_time)
      : file_(file), variable_(variable), need_of_time_(need_of_time) {
    axes_.start.assign(variable.dimensions.size(), 0);
  }

  FieldAxes Read() {
    RefuseCurvilinear();
    for (std::size_t i = 0; i < variable_.dimensions.size(); ++i) {
      Assign(static_cast<int>(i));
    }
    if (lat_ == nullptr || lon_ == nullptr) {
      file_.Refuse(
          variable_,
          "expected a latitude and a longitude among its dimensions "
          "(standard_name, units degrees_north/degrees_east, or name)");
    }
    axes_.grid = Grid(Longitudes(), Latitudes());
    ReadTimes();
    return std::move(axes_);
  }

 private:
  const NetcdfDimension& Dimension(int position) const {
    return file_.dimensions()[variable_.dimensions[position]];
  }
  bool HasDimension(int dimension) const {
    const std::vector<int>& own = variable_.dimensions;
    return std::find(own.begin(), own.end(), dimension) != own.end();
  }

  void RefuseCurvilinear() const;
  const NetcdfVariable* CoordinateOf(int position) const;
  void Assign(int position);
  void AssignDepth(int position, const NetcdfVariable* coordinate);
  void Once(const NetcdfVariable* already, int position) const;

  std::vector<double> Coordinates(const NetcdfVariable& axis) const;
  bool Descends(const NetcdfVariable& axis,
                const std::vector<double>& values) const;
  std::vector<double> Latitudes();
  std::vector<double> Longitudes();
  std::vector<double> Wrapped(const std::vector<double>& ascending) const;
  const NetcdfVariable* TimeVariable() const;
  void ReadTimes();

  const NetcdfFile& file_;
  const NetcdfVariable& variable_;
  const TimeAxis need_of_time_;
  const NetcdfVariable* lat_ = nullptr;
  const NetcdfVariable* lon_ = nullptr;
  const NetcdfVariable* time_ = nullptr;
  FieldAxes axes_;
};

void AxesReader::RefuseCurvilinear() const {
  for (const NetcdfVariable& other : file_.variables()) {
    const AxisRole role = RoleOf(other);
    if (role != AxisRole::kLatitude && role != AxisRole::kLongitude) continue;
    if (other.dimensions.size() != 2 || !HasDimension(other.dimensions[0]) ||
        !HasDimension(other.dimensions[1])) {
      continue;
    }
    file_.Refuse(variable_,
                 "lies on a curvilinear grid (" + other.name +
                     " has two dimensions), expected latitude and longitude "
                     "with one dimension each");
  }
}

// The coordinate variable of a dimension: of the same name, or the only one
// along it that is a latitude, longitude, depth or time.
const NetcdfVariable* AxesReader::CoordinateOf(int position) const {
  const NetcdfVariable* found = nullptr;
  const int dimension = variable_.dimensions[position];
  for (const NetcdfVariable& other : file_.variables()) {
    if (other.dimensions != std::vector<int>{dimension}) continue;
    if (other.name == Dimension(position).name) return &other;
    if (found == nullptr && RoleOf(other) != AxisRole::kUnknown) found = &other;
  }
  return found;
}

void AxesReader::Once(const NetcdfVariable* already, int position) const {
  if (already == nullptr) return;
  file_.Refuse(variable_, "dimension " + Dimension(position).name + " and " +
                              already->name + " are of the same kind");
}

void AxesReader::Assign(int position) {
  const NetcdfVariable* coordinate = CoordinateOf(position);
  const AxisRole role = coordinate == nullptr
                            ? RoleByName(Dimension(position).name)
                            : RoleOf(*coordinate);
  // Levels and dimensions of size 1 are fixed to one index; all others must be
  // identified, or values would be read from the wrong position.
  if (role == AxisRole::kDepth) return AssignDepth(position, coordinate);
  if (role == AxisRole::kUnknown && Dimension(position).size == 1) return;
  if (role == AxisRole::kUnknown || coordinate == nullptr) {
    file_.Refuse(variable_, "dimension " + Dimension(position).name +
                                " is not understood, expected time, depth, "
                                "latitude and longitude with their values");
  }
  if (role == AxisRole::kTime) {
    Once(time_, position);
    time_ = coordinate;
    axes_.time = position;
  } else if (role == AxisRole::kLatitude) {
    Once(lat_, position);
    lat_ = coordinate;
    axes_.lat = position;
  } else {
    Once(lon_, position);
    lon_ = coordinate;
    axes_.lon = position;
  }
}

void AxesReader::AssignDepth(int position, const NetcdfVariable* coordinate) {
  if (coordinate == nullptr) return;
  const std::vector<double> depths = Coordinates(*coordinate);
  // Depths may be positive up or down: the shallowest has the least magnitude.
  const auto shallowest = std::min_element(
      depths.begin(), depths.end(),
      [](double a, double b) { return std::abs(a) < std::abs(b); });
  axes_.start[position] = static_cast<std::size_t>(shallowest - depths.begin());
}

std::vector<double> AxesReader::Coordinates(const NetcdfVariable& axis) const {
  const std::size_t size = file_.dimensions()[axis.dimensions[0]].size;
  if (size == 0 || size > kMaxCoordinates) {
    file_.Refuse(axis, "expected 1 to " + std::to_string(kMaxCoordinates) +
                           " values, found " + std::to_string(size));
  }
  if (axis.numbers.count("scale_factor") + axis.numbers.count("add_offset")) {
    file_.Refuse(axis, "expected a coordinate that is not packed");
  }
  const std::vector<double> values = file_.Values(axis);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isfinite(values[i]) && std::abs(values[i]) < 1e20) continue;
    file_.Refuse(axis, "value " + std::to_string(i) + " is missing");
  }
  return values;
}

bool AxesReader::Descends(const NetcdfVariable& axis,
                          const std::vector<double>& values) const {
  if (values.size() < 2) {
    file_.Refuse(axis, "expected at least two values, found one");
  }
  const bool descends = values[1] < values[0];
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double step = values[i] - values[i - 1];
    if (descends ? step < 0.0 : step > 0.0) continue;
    file_.Refuse(axis,
                 "expected values that only ascend or only descend, "
                 "value " +
                     std::to_string(i) + " does not");
  }
  return descends;
}

std::vector<double> AxesReader::Latitudes() {
  // The canonical grid runs from south to north, independent of the file.
  std::vector<double> values = Coordinates(*lat_);
  axes_.file_row.resize(values.size());
  std::iota(axes_.file_row.begin(), axes_.file_row.end(), std::size_t{0});
  if (Descends(*lat_, values)) {
    std::reverse(values.begin(), values.end());
    std::reverse(axes_.file_row.begin(), axes_.file_row.end());
  }
  if (values.front() < -90.0 || values.back() > 90.0) {
    file_.Refuse(*lat_, "expected degrees from -90 to 90");
  }
  return values;
}

std::vector<double> AxesReader::Longitudes() {
  // Step 1: ascending from west to east, remembering the file's columns.
  std::vector<double> values = Coordinates(*lon_);
  axes_.file_col.resize(values.size());
  std::iota(axes_.file_col.begin(), axes_.file_col.end(), std::size_t{0});
  if (Descends(*lon_, values)) {
    std::reverse(values.begin(), values.end());
    std::reverse(axes_.file_col.begin(), axes_.file_col.end());
  }
  // Values beyond two turns, or a repeated column: not longitudes.
  if (values.front() < -360.0 || values.back() > 720.0 ||
      values.back() - values.front() >= 360.0) {
    file_.Refuse(*lon_, "expected degrees that span less than a turn, found " +
                            std::to_string(values.front()) + " to " +
                            std::to_string(values.back()));
  }
  // Step 2: into [-180, 180), beginning with the westernmost column. A global
  // file from 0 to 360 is split at 180 and its halves are swapped.
  const std::vector<double> wrapped = Wrapped(values);
  const auto west = std::min_element(wrapped.begin(), wrapped.end());
  const auto turn = west - wrapped.begin();
  std::rotate(axes_.file_col.begin(), axes_.file_col.begin() + turn,
              axes_.file_col.end());
  std::vector<double> rotated(west, wrapped.end());
  rotated.insert(rotated.end(), wrapped.begin(), west);
  return rotated;
}

// Wraps each longitude into [-180, 180). A file that crosses 180 degrees must
// be global, i.e. its ends must meet.
std::vector<double> AxesReader::Wrapped(
    const std::vector<double>& ascending) const {
  std::vector<double> wrapped;
  double widest = 0.0;
  std::size_t seams = 0;
  for (std::size_t i = 0; i < ascending.size(); ++i) {
    const double lon = ascending[i];
    wrapped.push_back(lon - 360.0 * std::floor((lon + 180.0) / 360.0));
    if (i == 0) continue;
    widest = std::max(widest, lon - ascending[i - 1]);
    seams += wrapped[i] < wrapped[i - 1];  // Passed 180 degrees.
  }
  // From the last column around the globe to the first: a normal spacing in a
  // global file, the rest of the globe in a regional one.
  const double gap = ascending.front() + 360.0 - ascending.back();
  if (seams > 0 && gap > kSeamFactor * widest) {
    file_.Refuse(*lon_,
                 "the grid crosses the antimeridian (longitudes " +
                     std::to_string(ascending.front()) + " to " +
                     std::to_string(ascending.back()) +
                     "), which is not understood; expected one that does not");
  }
  return wrapped;
}

// Time variable of the variable's own dimension, or else a scalar one; null if
// there is none and none is required.
const NetcdfVariable* AxesReader::TimeVariable() const {
  if (time_ != nullptr) return time_;
  for (const NetcdfVariable& other : file_.variables()) {
    const bool dated = other.Text("units").find(" since ") != std::string::npos;
    if (other.dimensions.empty() && dated) return &other;
  }
  if (need_of_time_ == TimeAxis::kOptional) return nullptr;
  file_.Refuse(variable_,
               "expected a time (a dimension of it, or a scalar variable with "
               "units like \"hours since 2000-01-01 00:00:00\")");
}

void AxesReader::ReadTimes() {
  const NetcdfVariable* found = TimeVariable();
  if (found == nullptr) {
    axes_.time_s.push_back(std::nan(""));
    return;
  }
  const NetcdfVariable& time = *found;
  const std::vector<double> values =
      time.dimensions.empty() ? file_.Values(time) : Coordinates(time);
  CfTime cf;
  try {
    cf = ParseCfTime(time.Text("units"), time.Text("calendar"));
  } catch (const InputError& error) {
    file_.Refuse(time, error.what());
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double time_s = cf.epoch_s + values[i] * cf.unit_s;
    // Values beyond about 30,000 years are fill values. Negated comparison, to
    // catch NaN as well.
    if (!(std::abs(time_s) < 1e12)) {
      file_.Refuse(time, "time " + std::to_string(i) + " is missing");
    }
    if (i > 0 && !(time_s > axes_.time_s.back())) {
      file_.Refuse(
          time, "expected times that only ascend, time " + std::to_string(i) +
                    (time_s == axes_.time_s.back() ? " repeats" : " precedes") +
                    " the one before it");
    }
    axes_.time_s.push_back(time_s);
  }
}

}  // namespace

FieldAxes ReadFieldAxes(const NetcdfFile& file, const NetcdfVariable& variable,
                        TimeAxis time) {
  return AxesReader(file, variable, time).Read();
}

}  // namespace kg_base
