#include "kg_base/raster/vertical_axis.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "kg_base/common/text.h"
#include "kg_base/raster/unit_conversion.h"

namespace kg_base {
namespace {

// Which value of an axis is nearest to the surface.
enum class SurfaceEnd { kUnknown, kNearestToZero, kLeast, kGreatest };

// Levels beyond these are not what agents at the surface meet.
constexpr double kMaxSurfaceDepth_m = 10.0;
constexpr double kMaxSurfaceHeight_m = 100.0;
constexpr double kMinSurfacePressure_pa = 85000.0;

std::string WordsOf(const NetcdfVariable& variable) {
  return ToLowerAscii(variable.Text("standard_name") + " " +
                      variable.Text("long_name"));
}

class LevelFinder {
 public:
  LevelFinder(const NetcdfFile& file, const NetcdfVariable& variable,
              const NetcdfVariable& axis, const std::vector<double>& values)
      : file_(file),
        axis_(axis),
        values_(values),
        words_(WordsOf(axis)),
        units_(axis.Text("units")),
        positive_(ToLowerAscii(axis.Text("positive"))) {
    const std::string medium = WordsOf(variable);
    is_air_ = medium.find("wind") != std::string::npos ||
              medium.find("air_") != std::string::npos ||
              medium.find("air ") != std::string::npos;
  }

  SurfaceLevel Find() const {
    const SurfaceEnd end = End();
    if (end == SurfaceEnd::kUnknown && values_.size() > 1) Refuse();
    SurfaceLevel level;
    level.index = IndexOf(end);
    std::ostringstream text;
    text << axis_.name << " = " << values_[level.index];
    if (!units_.empty()) text << " " << units_;
    text << ", of " << values_.size()
         << (values_.size() == 1 ? " level" : " levels");
    level.text = text.str();
    if (IsFar(values_[level.index])) {
      level.warning = "the level nearest to the surface is " + level.text;
    }
    return level;
  }

 private:
  bool Says(const char* part) const {
    return words_.find(part) != std::string::npos;
  }
  bool IsNamed(std::initializer_list<const char*> names) const {
    const std::string name = ToLowerAscii(axis_.base_name);
    return std::find(names.begin(), names.end(), name) != names.end();
  }
  bool IsIn(const char* unit) const {
    return ConvertUnit(units_, unit).has_value();
  }
  bool IsAboveBed() const {
    return Says("sea_floor") || Says("sea floor") || Says("seafloor") ||
           Says("above bed") || Says("above the bed") || Says("bottom");
  }
  bool IsDepth() const {
    return !IsAboveBed() && (Says("depth") || (IsNamed({"depth", "deptht"}) &&
                                               !Says("pressure")));
  }
  bool IsHeight() const {
    return !IsAboveBed() && (Says("height") || Says("altitude"));
  }
  double Highest() const {
    return *std::max_element(values_.begin(), values_.end());
  }
  bool IsPressure() const { return Says("pressure") || IsIn("Pa"); }
  bool IsSeaPressure() const {
    return Says("sea_water_pressure") || Says("sea water pressure") ||
           // Decibars are the unit of oceanographers.
           (!Says("air_pressure") && !is_air_ &&
            (units_ == "dbar" || units_.compare(0, 7, "decibar") == 0));
  }

  SurfaceEnd End() const;
  SurfaceEnd EndBySign() const;
  std::size_t IndexOf(SurfaceEnd end) const;
  bool IsFar(double value) const;
  [[noreturn]] void Refuse() const;

  const NetcdfFile& file_;
  const NetcdfVariable& axis_;
  const std::vector<double>& values_;
  const std::string words_;  // Standard and long name, lower case.
  const std::string units_;
  const std::string positive_;
  bool is_air_ = false;
};

SurfaceEnd LevelFinder::End() const {
  if (IsAboveBed()) return SurfaceEnd::kGreatest;
  // Sigma of the ocean runs from -1 at the bed to 0; of the air from 0 at the
  // top to 1 at the ground.
  if (Says("ocean_sigma") || Says("ocean_s_") || Says("ocean_double")) {
    return SurfaceEnd::kNearestToZero;
  }
  if (Says("atmosphere") && Says("sigma")) return SurfaceEnd::kGreatest;
  if (Says("sigma")) {
    return is_air_ ? SurfaceEnd::kGreatest : SurfaceEnd::kNearestToZero;
  }
  if (Says("model_level_number")) return EndBySign();
  if (IsDepth()) return SurfaceEnd::kNearestToZero;
  if (IsHeight()) {
    // A height in the sea is counted from the bed or is negative.
    const bool is_clear = is_air_ || Highest() <= 0.0;
    return is_clear ? SurfaceEnd::kNearestToZero : SurfaceEnd::kUnknown;
  }
  if (IsPressure()) {
    return IsSeaPressure() ? SurfaceEnd::kLeast : SurfaceEnd::kGreatest;
  }
  return EndBySign();
}

// An axis that says only which way is up: in the sea the surface is the upper
// end, in the air the lower one. A sea level that is positive and up is counted
// from the bed or from the surface, which the axis does not tell.
SurfaceEnd LevelFinder::EndBySign() const {
  const bool up = positive_ == "up";
  if (!up && positive_ != "down") return SurfaceEnd::kUnknown;
  if (is_air_) return up ? SurfaceEnd::kLeast : SurfaceEnd::kGreatest;
  if (!up) return SurfaceEnd::kNearestToZero;
  return Highest() <= 0.0 ? SurfaceEnd::kGreatest : SurfaceEnd::kUnknown;
}

std::size_t LevelFinder::IndexOf(SurfaceEnd end) const {
  const auto key = [end](double value) {
    if (end == SurfaceEnd::kNearestToZero) return std::abs(value);
    return end == SurfaceEnd::kGreatest ? -value : value;
  };
  const auto found =
      std::min_element(values_.begin(), values_.end(),
                       [&](double a, double b) { return key(a) < key(b); });
  return static_cast<std::size_t>(found - values_.begin());
}

bool LevelFinder::IsFar(double value) const {
  if (IsAboveBed()) return true;  // How far depends on the depth of the sea.
  if (const auto pascal = ConvertUnit(units_, "Pa")) {
    const double pressure_pa = value * pascal->scale + pascal->offset;
    return IsSeaPressure() ? pressure_pa > kMaxSurfaceDepth_m * 1e4
                           : pressure_pa < kMinSurfacePressure_pa;
  }
  const auto metre = ConvertUnit(units_.empty() ? "m" : units_, "m");
  if (!metre) return false;
  const double distance_m = std::abs(value * metre->scale + metre->offset);
  if (IsHeight() && is_air_) return distance_m > kMaxSurfaceHeight_m;
  return distance_m > kMaxSurfaceDepth_m;
}

void LevelFinder::Refuse() const {
  file_.Refuse(axis_,
               "which of its " + std::to_string(values_.size()) +
                   " levels is the surface is not understood, expected a "
                   "standard_name such as depth, height, air_pressure or "
                   "height_above_sea_floor");
}

}  // namespace

SurfaceLevel FindSurface(const NetcdfFile& file, const NetcdfVariable& variable,
                         const NetcdfVariable& axis,
                         const std::vector<double>& values) {
  return LevelFinder(file, variable, axis, values).Find();
}

}  // namespace kg_base
