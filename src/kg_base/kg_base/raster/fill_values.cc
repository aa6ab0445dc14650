#include "kg_base/raster/fill_values.h"

#include <cmath>
#include <cstdlib>
#include <sstream>

namespace kg_base {
namespace {

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
    case netCDF::NcType::nc_INT64:
      return {static_cast<double>(NC_FILL_INT64)};
    case netCDF::NcType::nc_FLOAT:
    case netCDF::NcType::nc_DOUBLE:
      return {NC_FILL_DOUBLE};
    default:
      return {};
  }
}

// Fills above this magnitude are compared with a tolerance: no quantity comes
// near, and they are rounded in many ways.
constexpr double kHugeFill = 1e10;
constexpr double kFillTolerance = 1e-5;
// Rounding to single precision.
constexpr double kFloatTolerance = 6e-8;

// A usual fill is told from values that are smaller by this factor.
constexpr double kFillFactor = 50.0;

// Values that programs write where they have no data, without saying so.
constexpr double kUsualFills[] = {-99.0,    -999.0, -9999.0, -99999.0, -32768.0,
                                  -32767.0, 9999.0, 99999.0, 1e20,     1e30,
                                  1e36,     -1e34,  -1e30};

std::vector<double> NumbersOf(const NetcdfFile& file,
                              const NetcdfVariable& variable,
                              const std::string& attribute) {
  const std::string text = variable.Text(attribute);
  std::vector<double> numbers;
  std::istringstream words(text);
  std::string word;
  while (words >> word) {
    char* end = nullptr;
    const double number = std::strtod(word.c_str(), &end);
    // CDL writes the type as a suffix: "-9999.f".
    const bool has_suffix = end != word.c_str() && (*end == 'f' || *end == 's');
    if (end == word.c_str() || *(has_suffix ? end + 1 : end) != '\0') {
      file.Refuse(variable, "attribute " + attribute + ": \"" +
                                text.substr(0, 100) + "\" is no number");
    }
    numbers.push_back(number);
  }
  return numbers;
}

// The greatest magnitude of all values but `fill`.
double GreatestBeside(const std::vector<Raster>& rasters, float fill) {
  double greatest = 0.0;
  for (const Raster& raster : rasters) {
    for (const float value : raster) {
      if (std::isnan(value) || value == fill) continue;
      greatest = std::max(greatest, std::abs(static_cast<double>(value)));
    }
  }
  return greatest;
}

bool HasValue(const std::vector<Raster>& rasters, float wanted) {
  return std::any_of(
      rasters.begin(), rasters.end(), [wanted](const Raster& raster) {
        return std::find(raster.begin(), raster.end(), wanted) != raster.end();
      });
}

}  // namespace

FillValues::FillValues(const NetcdfFile& file, const NetcdfVariable& variable,
                       DefaultFills defaults)
    : is_real_(variable.type == netCDF::NcType::nc_FLOAT ||
               variable.type == netCDF::NcType::nc_DOUBLE) {
  if (defaults == DefaultFills::kCount) {
    Add(variable, DefaultFill(variable.type));
  }
  for (const char* attribute : {"_FillValue", "missing_value"}) {
    const auto number = variable.numbers.find(attribute);
    if (number != variable.numbers.end()) Add(variable, number->second);
    Add(variable, NumbersOf(file, variable, attribute));
  }
}

void FillValues::Add(const NetcdfVariable& variable,
                     const std::vector<double>& values) {
  for (const double value : values) {
    fills_.push_back(variable.WithDeclaredSign(value));
  }
}

bool FillValues::IsSame(double raw, double fill) const {
  if (raw == fill) return true;
  if (!is_real_) return false;
  const double tolerance =
      std::abs(fill) >= kHugeFill ? kFillTolerance : kFloatTolerance;
  return std::abs(raw - fill) <= tolerance * std::abs(fill);
}

std::optional<UndeclaredFill> FindUndeclaredFill(
    const std::vector<Raster>& rasters) {
  for (const double fill : kUsualFills) {
    const float value = static_cast<float>(fill);
    if (!HasValue(rasters, value)) continue;
    const double others = GreatestBeside(rasters, value);
    if (others * kFillFactor <= std::abs(fill)) {
      return UndeclaredFill{fill, others};
    }
  }
  return std::nullopt;
}

}  // namespace kg_base
