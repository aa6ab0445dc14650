// Spacing of the values of an axis: of longitudes, latitudes or times.

#ifndef KG_BASE_RASTER_STEPS_H_
#define KG_BASE_RASTER_STEPS_H_

#include <vector>

namespace kg_base {

// Differences of neighbours, one fewer than there are values.
std::vector<double> StepsBetween(const std::vector<double>& values);

// The lower of the two in the middle if their number is even. There must be at
// least one.
double LowerMedian(std::vector<double> values);

}  // namespace kg_base

#endif  // KG_BASE_RASTER_STEPS_H_
