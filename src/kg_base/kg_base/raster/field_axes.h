// Which dimension of a gridded file's variable is which, and the canonical grid
// and times behind them. CF attributes first, names second.
// Source: CF-1.8, sections 4 and 5.

#ifndef KG_BASE_RASTER_FIELD_AXES_H_
#define KG_BASE_RASTER_FIELD_AXES_H_

#include <cstddef>
#include <vector>

#include "kg_base/raster/grid.h"
#include "kg_base/raster/netcdf_file.h"

namespace kg_base {

struct FieldAxes {
  // Positions in the variable's list of dimensions; -1: it has none.
  int time = -1;
  int lat = -1;
  int lon = -1;
  std::vector<std::size_t> start;  // The shallowest level; 0 elsewhere.

  Grid grid;
  std::vector<std::size_t> file_row;  // Index in the file for each row.
  std::vector<std::size_t> file_col;
  std::vector<double> time_s;
};

// May a variable be of no time? Then its one time is NaN.
enum class TimeAxis { kRequired, kOptional };

// Throws InputError for what is not understood: curvilinear grids, grids across
// the antimeridian, axes or times that do not run one way, unknown dimensions.
FieldAxes ReadFieldAxes(const NetcdfFile& file, const NetcdfVariable& variable,
                        TimeAxis time = TimeAxis::kRequired);

}  // namespace kg_base

#endif  // KG_BASE_RASTER_FIELD_AXES_H_
