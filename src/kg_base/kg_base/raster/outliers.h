// Values of a gridded quantity that are probably faults: spikes of single
// cells. They are counted, not removed.

#ifndef KG_BASE_RASTER_OUTLIERS_H_
#define KG_BASE_RASTER_OUTLIERS_H_

#include <cstddef>
#include <string>
#include <vector>

#include "kg_base/raster/grid.h"

namespace kg_base {

struct OutlierValues {
  std::size_t count = 0;
  std::size_t raster = 0;  // Of the first one.
  Cell cell;               // Of the first one.
  float value = 0.0f;      // Of the first one.
};

// A value is an outlier if it is more than 8 robust standard deviations (1.4826
// times the median absolute deviation) away from the median of all values, and
// above or below all of its four neighbours by as much; at least two of them
// must have data. Median and deviation are those of a sample of at most 100,000
// values. A quantity that is constant in most cells has no outliers.
OutlierValues FindOutliers(const Grid& grid,
                           const std::vector<Raster>& rasters);

// May single cells of a quantity (CF standard name) differ much from all
// others by nature, as ground that burns?
bool HasSpikes(const std::string& standard_name);

}  // namespace kg_base

#endif  // KG_BASE_RASTER_OUTLIERS_H_
