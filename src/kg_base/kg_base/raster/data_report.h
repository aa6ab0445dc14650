// What was read of a variable of a gridded file, and which choices the reader
// made where the file leaves some: texts for users.

#ifndef KG_BASE_RASTER_DATA_REPORT_H_
#define KG_BASE_RASTER_DATA_REPORT_H_

#include <cstddef>
#include <string>
#include <vector>

namespace kg_base {

struct VariableReport {
  std::string quantity;  // "eastward velocity", ...
  std::string variable;  // Its name in the file, with its group.
  std::string level;     // "depth = 0.5 m, of 40 levels"; "" = no levels.
  std::string times;     // "17 times, 2020-11-01T00:00:00Z to ..."; "" = none.
  std::string unit;      // "cm s-1, converted to m/s"; "" = its own unit.
  std::size_t cells = 0;
  // Cells that have no data at any time, among them those of holes.
  std::size_t cells_without_data = 0;
  // One line each, without the names of file and variable.
  std::vector<std::string> warnings;
};

}  // namespace kg_base

#endif  // KG_BASE_RASTER_DATA_REPORT_H_
