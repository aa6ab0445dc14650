// The contents of a gridded file in canonical form: one grid, one list of
// times, and for each quantity one raster per time, in SI (degree Celsius).

#ifndef KG_BASE_RASTER_FIELD_FILE_H_
#define KG_BASE_RASTER_FIELD_FILE_H_

#include <string>
#include <vector>

#include "kg_base/raster/data_report.h"
#include "kg_base/raster/field_quantity.h"
#include "kg_base/raster/grid.h"

namespace kg_base {

struct QuantitySeries {
  FieldQuantity quantity = FieldQuantity::kTemperature;
  std::string variable;         // Its name in the file.
  std::string standard_name;    // Empty if it has none.
  std::vector<Raster> at_time;  // One raster for each time of the file.
  VariableReport report;        // How it was read.
};

struct FieldFile {
  std::string path;
  std::string sha256;  // Digest of the whole file.
  Grid grid;
  // Unix seconds, strictly ascending; one NaN for a variable without time.
  std::vector<double> time_s;
  std::vector<QuantitySeries> series;  // In the order requested.
};

}  // namespace kg_base

#endif  // KG_BASE_RASTER_FIELD_FILE_H_
