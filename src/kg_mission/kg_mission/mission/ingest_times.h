// Selection of the time steps of a file for a window.

#ifndef KG_MISSION_MISSION_INGEST_TIMES_H_
#define KG_MISSION_MISSION_INGEST_TIMES_H_

#include <vector>

#include "kg_mission/mission/mission.h"

namespace kg_mission {

// A step represents times up to this far away: daily files have one step per
// day, at any hour.
inline constexpr double kStepReach_s = 12.0 * 3600.0;
// Currents are interpolated over gaps up to this long; a longer gap means a
// missing day.
inline constexpr double kMaxGap_s = 36.0 * 3600.0;

// First and last step needed for the field of a window: the steps inside and
// the next one on either side. `time_s` is ascending (Unix seconds). Throws
// InputError if the steps do not reach the window's ends or leave a gap.
struct StepRange {
  int first = 0;
  int last = 0;
};
StepRange StepsOfField(const std::vector<double>& time_s,
                       const TimeWindow& window);

// The step nearest to the window's middle. Throws InputError if none is within
// kStepReach_s.
int StepOfWindow(const std::vector<double>& time_s, const TimeWindow& window);

// The step of the window and the one a day earlier; for window 0, if there is
// no earlier one, the step a day later (A14). Throws InputError.
struct StepPair {
  int step = 0;
  int previous = 0;
};
StepPair StepsOfDifference(const std::vector<double>& time_s,
                           const TimeWindow& window);

}  // namespace kg_mission

#endif  // KG_MISSION_MISSION_INGEST_TIMES_H_
