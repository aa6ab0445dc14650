// The steps between the times of a gridded file: how far apart they usually
// are, and where some are missing.

#ifndef KG_BASE_RASTER_TIME_STEPS_H_
#define KG_BASE_RASTER_TIME_STEPS_H_

#include <cstddef>
#include <string>
#include <vector>

namespace kg_base {

struct TimeSteps {
  double usual_s = 0.0;     // The median step; 0 with fewer than two times.
  std::size_t missing = 0;  // Steps that gaps leave out.
  // Ends of the first gap [Unix s], if any are missing.
  double gap_begin_s = 0.0;
  double gap_end_s = 0.0;
};

// `time_s`: Unix seconds, ascending. Months count as steps of equal length.
TimeSteps FindTimeSteps(const std::vector<double>& time_s);

// "2020-11-01T00:00:00Z"; for a year that has no such text the Unix seconds.
std::string TimeText(double time_s);

}  // namespace kg_base

#endif  // KG_BASE_RASTER_TIME_STEPS_H_
