#include "kg_base/raster/time_steps.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "kg_base/common/date_time.h"

namespace kg_base {
namespace {

// A step above this multiple of the usual one is a gap. Months differ by less.
constexpr double kGapFactor = 1.5;

}  // namespace

TimeSteps FindTimeSteps(const std::vector<double>& time_s) {
  TimeSteps found;
  std::vector<double> steps_s;
  for (std::size_t i = 1; i < time_s.size(); ++i) {
    steps_s.push_back(time_s[i] - time_s[i - 1]);
  }
  if (steps_s.empty()) return found;
  const auto middle = steps_s.begin() + (steps_s.size() - 1) / 2;
  std::nth_element(steps_s.begin(), middle, steps_s.end());
  found.usual_s = *middle;
  for (std::size_t i = 1; i < time_s.size(); ++i) {
    const double step_s = time_s[i] - time_s[i - 1];
    if (!(step_s > kGapFactor * found.usual_s)) continue;
    if (found.missing == 0) {
      found.gap_begin_s = time_s[i - 1];
      found.gap_end_s = time_s[i];
    }
    found.missing +=
        static_cast<std::size_t>(std::round(step_s / found.usual_s)) - 1;
  }
  return found;
}

std::string TimeText(double time_s) {
  try {
    return FormatDateTime(time_s);
  } catch (const std::invalid_argument&) {
    return std::to_string(time_s) + " s since 1970";
  }
}

}  // namespace kg_base
