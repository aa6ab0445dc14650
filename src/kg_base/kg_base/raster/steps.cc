#include "kg_base/raster/steps.h"

#include <algorithm>
#include <cstddef>

namespace kg_base {

std::vector<double> StepsBetween(const std::vector<double>& values) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < values.size(); ++i) {
    steps.push_back(values[i] - values[i - 1]);
  }
  return steps;
}

double LowerMedian(std::vector<double> values) {
  const auto middle =
      values.begin() + (static_cast<int>(values.size()) - 1) / 2;
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace kg_base
