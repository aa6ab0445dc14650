// Roles of the dimensions of a gridded file's variable, and its canonical grid
// and times. CF attributes take precedence over names.
// Source: CF-1.8, sections 4 and 5.

#ifndef KG_BASE_RASTER_FIELD_AXES_H_
#define KG_BASE_RASTER_FIELD_AXES_H_

#include <cstddef>
#include <limits>
#include <vector>

#include "kg_base/raster/grid.h"
#include "kg_base/raster/netcdf_file.h"

namespace kg_base {

struct FieldAxes {
  // Positions in the variable's list of dimensions; -1: it has none.
  int time = -1;
  int lat = -1;
  int lon = -1;
  std::vector<std::size_t> start;  // The level of the surface; 0 elsewhere.

  Grid grid;
  // Index in the file for each row and column, or kNotInFile.
  std::vector<std::size_t> file_row;
  std::vector<std::size_t> file_col;
  std::size_t rows_in_file = 0;
  std::size_t cols_in_file = 0;
  std::vector<double> time_s;          // When the values hold.
  std::vector<std::size_t> file_time;  // Index in the file of each time.
  std::size_t times_in_file = 1;
  double issue_time_s = std::numeric_limits<double>::quiet_NaN();

  std::string level;  // As in VariableReport.
  std::vector<std::string> warnings;
};

// May a variable lack a time? Its only time is then NaN. Optional times stay in
// the order of the file, because users refer to them by their index there.
enum class TimeAxis { kRequired, kOptional };

// Times of means are the middles of their periods (CF "bounds"), unless
// cell_methods says that values hold at points. Throws InputError for
// unsupported files: curvilinear and rotated grids, grids across the
// antimeridian, axes that are not monotonic, unknown dimensions and
// levels.
FieldAxes ReadFieldAxes(const NetcdfFile& file, const NetcdfVariable& variable,
                        TimeAxis time = TimeAxis::kRequired);

}  // namespace kg_base

#endif  // KG_BASE_RASTER_FIELD_AXES_H_
