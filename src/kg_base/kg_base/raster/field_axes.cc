#include "kg_base/raster/field_axes.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "kg_base/common/input_error.h"
#include "kg_base/raster/axis_role.h"
#include "kg_base/raster/coordinate_axis.h"
#include "kg_base/raster/coordinate_values.h"
#include "kg_base/raster/field_times.h"
#include "kg_base/raster/vertical_axis.h"

namespace kg_base {
namespace {

// Two-dimensional coordinates above this size are not examined.
constexpr std::size_t kMaxPlane = std::size_t{1} << 24;
// Deviation of regular two-dimensional coordinates, in spacings.
constexpr double kPlaneTolerance = 0.01;

// Values of an axis in the order of the file, and the variable they are from.
struct AxisValues {
  const NetcdfVariable* source = nullptr;
  std::vector<double> values;
};

// The only values along one dimension of a plane of rows and columns, or empty
// if they vary along the other one.
std::vector<double> AlongOne(const std::vector<double>& plane, std::size_t rows,
                             std::size_t cols, bool along_rows) {
  const std::size_t size = along_rows ? rows : cols;
  const std::size_t step = along_rows ? cols : 1;
  std::vector<double> values;
  for (std::size_t i = 0; i < size; ++i) values.push_back(plane[i * step]);
  if (size < 2) return {};
  const double allowed = kPlaneTolerance * std::abs(values[1] - values[0]);
  for (std::size_t i = 0; i < plane.size(); ++i) {
    const double expected = values[along_rows ? i / cols : i % cols];
    if (!(std::abs(plane[i] - expected) <= allowed)) return {};  // Also NaN.
  }
  return values;
}

class AxesReader {
 public:
  AxesReader(const NetcdfFile& file, const NetcdfVariable& variable,
             TimeAxis need_of_time)
      : file_(file), variable_(variable), need_of_time_(need_of_time) {
    axes_.start.assign(variable.dimensions.size(), 0);
  }

  FieldAxes Read() {
    ReadPlanes();
    for (std::size_t i = 0; i < variable_.dimensions.size(); ++i) {
      const int position = static_cast<int>(i);
      if (position != axes_.lat && position != axes_.lon) Assign(position);
    }
    if (lat_.source == nullptr || lon_.source == nullptr) {
      file_.Refuse(
          variable_,
          "expected a latitude and a longitude among its dimensions "
          "(standard_name, units degrees_north/degrees_east, or name)");
    }
    ReadGrid();
    ReadScalarLevel();
    ReadTimes();
    return std::move(axes_);
  }

 private:
  const NetcdfDimension& Dimension(int position) const {
    return file_.dimensions()[variable_.dimensions[position]];
  }
  int PositionOf(int dimension) const {
    const std::vector<int>& own = variable_.dimensions;
    const auto found = std::find(own.begin(), own.end(), dimension);
    return found == own.end() ? -1 : static_cast<int>(found - own.begin());
  }
  void Warn(const std::vector<std::string>& warnings) {
    axes_.warnings.insert(axes_.warnings.end(), warnings.begin(),
                          warnings.end());
  }

  void ReadPlanes();
  void ReadPlane(const NetcdfVariable& plane);
  const NetcdfVariable* CoordinateOf(int position) const;
  void Assign(int position);
  void AssignLevel(int position, const NetcdfVariable* coordinate);
  void AssignHorizontal(int position, const NetcdfVariable& coordinate,
                        AxisValues* values, int* assigned);
  void TakeLevel(const SurfaceLevel& level);
  void ReadScalarLevel();
  void Once(bool already, int position) const;
  void ReadGrid();
  void ReadTimes();

  const NetcdfFile& file_;
  const NetcdfVariable& variable_;
  const TimeAxis need_of_time_;
  AxisValues lat_;
  AxisValues lon_;
  const NetcdfVariable* time_ = nullptr;
  FieldAxes axes_;
};

// Latitudes and longitudes with two dimensions are read if they vary along one
// of them only; all others are those of a curvilinear grid.
void AxesReader::ReadPlanes() {
  for (const NetcdfVariable& other : file_.variables()) {
    if (other.dimensions.size() != 2 || !other.IsVisibleTo(variable_)) continue;
    const AxisRole role = RoleOf(other);
    const bool is_horizontal =
        role == AxisRole::kLatitude || role == AxisRole::kLongitude;
    if (is_horizontal && PositionOf(other.dimensions[0]) >= 0 &&
        PositionOf(other.dimensions[1]) >= 0) {
      ReadPlane(other);
    }
  }
}

void AxesReader::ReadPlane(const NetcdfVariable& plane) {
  const std::size_t rows = file_.dimensions()[plane.dimensions[0]].size;
  const std::size_t cols = file_.dimensions()[plane.dimensions[1]].size;
  const bool is_lat = RoleOf(plane) == AxisRole::kLatitude;
  AxisValues& axis = is_lat ? lat_ : lon_;
  int& position = is_lat ? axes_.lat : axes_.lon;
  const bool can_be_read = rows > 1 && cols > 1 && rows * cols <= kMaxPlane;
  const std::vector<double> values =
      can_be_read ? UnpackedValues(file_, plane) : std::vector<double>();
  for (const bool along_rows : {true, false}) {
    if (!can_be_read) break;
    std::vector<double> along = AlongOne(values, rows, cols, along_rows);
    if (along.empty()) continue;
    axis = {&plane, std::move(along)};
    position = PositionOf(plane.dimensions[along_rows ? 0 : 1]);
    return;
  }
  file_.Refuse(variable_,
               "lies on a curvilinear grid (" + plane.name +
                   " has two dimensions), expected latitude and longitude "
                   "with one dimension each");
}

// The coordinate variable of a dimension: the one that says most clearly what
// it is; of several the one of the dimension's name.
const NetcdfVariable* AxesReader::CoordinateOf(int position) const {
  const NetcdfVariable* best = nullptr;
  int most = -1;
  const int dimension = variable_.dimensions[position];
  for (const NetcdfVariable& other : file_.variables()) {
    if (other.dimensions != std::vector<int>{dimension} ||
        !other.IsVisibleTo(variable_)) {
      continue;
    }
    const bool has_its_name = other.base_name == Dimension(position).name;
    const AxisRole role = RoleOf(other);
    // Times of the forecast are taken only where nothing else is there.
    const int strength =
        role == AxisRole::kOtherTime ? 1 : 2 * RoleStrength(other);
    if (strength == 0 && !has_its_name) continue;
    const int score = 2 * strength + (has_its_name ? 1 : 0);
    if (score <= most) continue;
    most = score;
    best = &other;
  }
  return best;
}

void AxesReader::Once(bool already, int position) const {
  if (!already) return;
  file_.Refuse(variable_, "dimension " + Dimension(position).name +
                              " and another one are of the same kind");
}

void AxesReader::Assign(int position) {
  const NetcdfVariable* coordinate = CoordinateOf(position);
  const AxisRole role = coordinate == nullptr
                            ? RoleByName(Dimension(position).name)
                            : RoleOf(*coordinate);
  // Levels and dimensions of size 1 are fixed to one index; all others must be
  // identified, or values would be read from the wrong position.
  if (role == AxisRole::kVertical) return AssignLevel(position, coordinate);
  if (role == AxisRole::kGridCoordinate) {
    file_.Refuse(variable_, "lies on a rotated or projected grid (" +
                                coordinate->name +
                                " is no longitude or latitude), expected "
                                "latitude and longitude with one dimension "
                                "each");
  }
  const bool is_single = Dimension(position).size == 1;
  const bool is_open =
      role == AxisRole::kUnknown || role == AxisRole::kOtherTime;
  if (is_open && is_single) return;
  if (role == AxisRole::kOtherTime) {
    file_.Refuse(*coordinate,
                 "is a reference or lead time of a forecast, expected the "
                 "time when values hold along dimension " +
                     Dimension(position).name);
  }
  if (is_open || coordinate == nullptr) {
    const std::string units =
        coordinate == nullptr ? "" : coordinate->Text("units");
    file_.Refuse(variable_,
                 "dimension " + Dimension(position).name +
                     (units.empty() ? "" : " in \"" + units + "\"") +
                     " is not understood, expected time, depth, latitude and "
                     "longitude with their values");
  }
  if (role == AxisRole::kTime) {
    Once(time_ != nullptr, position);
    time_ = coordinate;
    axes_.time = position;
  } else if (role == AxisRole::kLatitude) {
    AssignHorizontal(position, *coordinate, &lat_, &axes_.lat);
  } else {
    AssignHorizontal(position, *coordinate, &lon_, &axes_.lon);
  }
}

void AxesReader::AssignHorizontal(int position,
                                  const NetcdfVariable& coordinate,
                                  AxisValues* values, int* assigned) {
  Once(values->source != nullptr, position);
  *values = {&coordinate, CoordinateValues(file_, coordinate)};
  *assigned = position;
  if (RoleStrength(coordinate) > 1) return;
  axes_.warnings.push_back(coordinate.name +
                           " has neither standard_name nor units: taken by "
                           "its name as degrees");
}

void AxesReader::AssignLevel(int position, const NetcdfVariable* coordinate) {
  if (coordinate == nullptr) {
    if (Dimension(position).size == 1) return;
    file_.Refuse(variable_,
                 "dimension " + Dimension(position).name + " has " +
                     std::to_string(Dimension(position).size) +
                     " levels without values, expected a coordinate variable "
                     "that tells which one is the surface");
  }
  const SurfaceLevel level = FindSurface(file_, variable_, *coordinate,
                                         CoordinateValues(file_, *coordinate));
  axes_.start[position] = level.index;
  TakeLevel(level);
}

void AxesReader::TakeLevel(const SurfaceLevel& level) {
  axes_.level = level.text;
  if (!level.warning.empty()) axes_.warnings.push_back(level.warning);
}

// A level that is no dimension, but a scalar that "coordinates" names.
void AxesReader::ReadScalarLevel() {
  if (!axes_.level.empty()) return;
  std::istringstream names(variable_.Text("coordinates"));
  std::string name;
  while (names >> name) {
    for (const NetcdfVariable& other : file_.variables()) {
      if (other.base_name != name || !other.dimensions.empty() ||
          !other.IsVisibleTo(variable_) ||
          RoleOf(other) != AxisRole::kVertical) {
        continue;
      }
      TakeLevel(
          FindSurface(file_, variable_, other, CoordinateValues(file_, other)));
    }
  }
}

void AxesReader::ReadGrid() {
  // The canonical grid runs from south to north, independent of the file.
  axes_.rows_in_file = lat_.values.size();
  axes_.cols_in_file = lon_.values.size();
  CoordinateAxis lat = LatitudeAxis(file_, *lat_.source, lat_.values);
  CoordinateAxis lon = LongitudeAxis(file_, *lon_.source, lon_.values);
  axes_.file_row = std::move(lat.in_file);
  axes_.file_col = std::move(lon.in_file);
  Warn(lat.warnings);
  Warn(lon.warnings);
  axes_.grid = Grid(std::move(lon.centres_deg), std::move(lat.centres_deg));
}

void AxesReader::ReadTimes() {
  const bool is_required = need_of_time_ == TimeAxis::kRequired;
  FieldTimes times = ReadFieldTimes(
      file_, variable_, time_, is_required,
      is_required ? TimeOrder::kAscending : TimeOrder::kAsInFile);
  axes_.time_s = std::move(times.time_s);
  axes_.file_time = std::move(times.in_file);
  axes_.issue_time_s = times.issue_time_s;
  if (axes_.time >= 0) axes_.times_in_file = Dimension(axes_.time).size;
  Warn(times.warnings);
}

}  // namespace

FieldAxes ReadFieldAxes(const NetcdfFile& file, const NetcdfVariable& variable,
                        TimeAxis time) {
  return AxesReader(file, variable, time).Read();
}

}  // namespace kg_base
