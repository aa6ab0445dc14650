#include "kg_mission/mission/ingest_times.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "kg_base/common/date_time.h"
#include "kg_base/common/input_error.h"

namespace kg_mission {
namespace {

using kg_base::FormatDateTime;

constexpr double kDay_s = 86400.0;

[[noreturn]] void Refuse(const std::vector<double>& time_s,
                         const TimeWindow& window, const std::string& need) {
  std::string there = "no time steps";
  if (!time_s.empty()) {
    there = std::to_string(time_s.size()) + " steps from " +
            FormatDateTime(time_s.front()) + " to " +
            FormatDateTime(time_s.back());
  }
  throw kg_base::InputError("too few days: has " + there + "; window " +
                            std::to_string(window.index) + " (" +
                            FormatDateTime(window.begin_s) + " to " +
                            FormatDateTime(window.end_s) + ") needs " + need);
}

// The nearest step; the earlier one of two equally near.
std::optional<int> NearestStep(const std::vector<double>& time_s,
                               double wanted_s) {
  std::optional<int> best;
  double best_distance_s = kStepReach_s;
  for (int i = 0; i < static_cast<int>(time_s.size()); ++i) {
    const double distance_s = std::abs(time_s[i] - wanted_s);
    if (distance_s < best_distance_s ||
        (!best && distance_s <= best_distance_s)) {
      best = i;
      best_distance_s = distance_s;
    }
  }
  return best;
}

}  // namespace

StepRange StepsOfField(const std::vector<double>& time_s,
                       const TimeWindow& window) {
  const bool reaches = !time_s.empty() &&
                       time_s.front() - kStepReach_s <= window.begin_s &&
                       time_s.back() + kStepReach_s >= window.end_s;
  if (!reaches) {
    Refuse(time_s, window, "steps that reach within 12 h of both its ends");
  }
  // From the last step at or before the window's begin to the first one at or
  // after its end, limited to the steps in the file.
  const auto begin = time_s.begin();
  const auto after_begin =
      std::upper_bound(begin, time_s.end(), window.begin_s);
  const auto at_end = std::lower_bound(begin, time_s.end(), window.end_s);
  const auto last_step = static_cast<std::ptrdiff_t>(time_s.size()) - 1;
  const std::ptrdiff_t first =
      std::max<std::ptrdiff_t>(after_begin - begin - 1, 0);
  const std::ptrdiff_t last = std::min(at_end - begin, last_step);
  for (std::ptrdiff_t i = first; i < last; ++i) {
    if (!(time_s[i + 1] - time_s[i] <= kMaxGap_s)) {
      Refuse(time_s, window,
             "a step between " + FormatDateTime(time_s[i]) + " and " +
                 FormatDateTime(time_s[i + 1]));
    }
  }
  return {static_cast<int>(first), static_cast<int>(last)};
}

int StepOfWindow(const std::vector<double>& time_s, const TimeWindow& window) {
  const double middle_s = 0.5 * (window.begin_s + window.end_s);
  const std::optional<int> step = NearestStep(time_s, middle_s);
  if (step) return *step;
  Refuse(time_s, window,
         "a step within 12 h of its middle, " + FormatDateTime(middle_s));
}

StepPair StepsOfDifference(const std::vector<double>& time_s,
                           const TimeWindow& window) {
  const int step = StepOfWindow(time_s, window);
  const std::optional<int> before = NearestStep(time_s, time_s[step] - kDay_s);
  if (before && *before != step) return {step, *before};
  const std::optional<int> after = NearestStep(time_s, time_s[step] + kDay_s);
  if (window.index == 0 && after && *after != step) return {step, *after};
  Refuse(time_s, window,
         "a step within 12 h of a day before, " +
             FormatDateTime(time_s[step] - kDay_s) +
             " (N windows need N + 1 days)");
}

}  // namespace kg_mission
