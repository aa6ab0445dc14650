// What was read from a variable of a gridded file, and which choices the reader
// made where the file is ambiguous: texts for users.

#ifndef KG_BASE_RASTER_DATA_REPORT_H_
#define KG_BASE_RASTER_DATA_REPORT_H_

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace kg_base {

struct VariableReport {
  std::string quantity;  // "eastward velocity", ...
  std::string variable;  // Its name in the file, with its group.
  std::string level;     // "depth = 0.5 m, of 40 levels"; "" = no levels.
  // "17 times, 2020-11-01T00:00:00Z to ..., every 6 h"; "" = none.
  std::string times;
  std::string unit;  // "cm s-1, converted to m/s"; "" = its own unit.
  std::size_t cells = 0;
  // Cells that have no data at any time, among them those of holes.
  std::size_t cells_without_data = 0;
  // When the forecast was made [Unix s]; NaN if the file does not tell.
  double issue_time_s = std::numeric_limits<double>::quiet_NaN();
  std::size_t impossible_values = 0;  // Outside the valid range: no data.
  std::size_t outliers = 0;           // As in outliers.h; they are kept.
  // One line each, without the names of file and variable.
  std::vector<std::string> warnings;
};

}  // namespace kg_base

#endif  // KG_BASE_RASTER_DATA_REPORT_H_
