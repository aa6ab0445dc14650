#include "kg_base/raster/time_steps.h"

#include <cmath>
#include <stdexcept>

#include "kg_base/common/date_time.h"
#include "kg_base/raster/steps.h"

namespace kg_base {
namespace {

// A step above this multiple of the usual one is a gap. Months differ by less.
constexpr double kGapFactor = 1.5;

}  // namespace

TimeSteps FindTimeSteps(const std::vector<double>& time_s) {
  TimeSteps found;
  const std::vector<double> steps_s = StepsBetween(time_s);
  if (steps_s.empty()) return found;
  found.usual_s = LowerMedian(steps_s);
  for (std::size_t i = 0; i < steps_s.size(); ++i) {
    if (!(steps_s[i] > kGapFactor * found.usual_s)) continue;
    if (found.missing == 0) {
      found.gap_begin_s = time_s[i];
      found.gap_end_s = time_s[i + 1];
    }
    found.missing +=
        static_cast<std::size_t>(std::round(steps_s[i] / found.usual_s)) - 1;
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
