// When the values of a gridded file's variable hold.
// Source: CF-1.8, sections 4.4, 7.1 (bounds) and 7.3 (cell_methods).

#ifndef KG_BASE_RASTER_FIELD_TIMES_H_
#define KG_BASE_RASTER_FIELD_TIMES_H_

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "kg_base/raster/netcdf_file.h"

namespace kg_base {

struct FieldTimes {
  std::vector<double> time_s;  // Unix seconds; one NaN if there is no time.
  std::vector<std::size_t> in_file;  // Index in the file of each time.
  // When the forecast was made [Unix s]; NaN if the file does not tell.
  double issue_time_s = std::numeric_limits<double>::quiet_NaN();
  std::vector<std::string> warnings;
};

enum class TimeOrder {
  // Strictly ascending; of equal times in the file the one written last, as
  // appended runs of a model update what they overlap.
  kAscending,
  kAsInFile,
};

// `along`: the time of the variable's own dimension; null if it has none, then
// a time with a single value is looked for, never a reference or lead time.
// Values of periods hold in their middle. Throws InputError if there is no time
// though it is required, if several could be meant or if it is not understood.
FieldTimes ReadFieldTimes(const NetcdfFile& file,
                          const NetcdfVariable& variable,
                          const NetcdfVariable* along, bool is_required,
                          TimeOrder order = TimeOrder::kAscending);

}  // namespace kg_base

#endif  // KG_BASE_RASTER_FIELD_TIMES_H_
