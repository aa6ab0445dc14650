#include "kg_base/raster/coordinate_values.h"

#include <cmath>
#include <string>

#include "kg_base/raster/fill_values.h"

namespace kg_base {
namespace {

constexpr std::size_t kMaxCoordinates = 100000;

}  // namespace

double SingleNumber(const NetcdfFile& file, const NetcdfVariable& variable,
                    const std::string& attribute, double absent) {
  if (variable.texts.count(attribute) > 0) {
    file.Refuse(variable, "attribute " + attribute + ": expected a number");
  }
  const auto found = variable.numbers.find(attribute);
  if (found == variable.numbers.end()) return absent;
  if (found->second.size() != 1 || !std::isfinite(found->second[0])) {
    file.Refuse(variable, "attribute " + attribute + ": expected one number");
  }
  return found->second[0];
}

std::vector<double> UnpackedValues(const NetcdfFile& file,
                                   const NetcdfVariable& variable) {
  const double scale = SingleNumber(file, variable, "scale_factor", 1.0);
  const double offset = SingleNumber(file, variable, "add_offset", 0.0);
  std::vector<double> values = file.Values(variable);
  for (double& value : values) value = value * scale + offset;
  return values;
}

std::vector<double> CoordinateValues(const NetcdfFile& file,
                                     const NetcdfVariable& axis) {
  const std::size_t size =
      axis.dimensions.empty() ? 1 : file.dimensions()[axis.dimensions[0]].size;
  if (size == 0 || size > kMaxCoordinates) {
    file.Refuse(axis, "expected 1 to " + std::to_string(kMaxCoordinates) +
                          " values, found " + std::to_string(size));
  }
  const FillValues fills(file, axis, DefaultFills::kDoNotCount);
  const std::vector<double> raw = file.Values(axis);
  for (std::size_t i = 0; i < raw.size(); ++i) {
    if (std::isfinite(raw[i]) && std::abs(raw[i]) < 1e20 &&
        !fills.Contains(raw[i])) {
      continue;
    }
    file.Refuse(axis, "value " + std::to_string(i) + " is missing");
  }
  return UnpackedValues(file, axis);
}

}  // namespace kg_base
