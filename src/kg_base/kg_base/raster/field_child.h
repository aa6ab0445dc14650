// Reads a gridded file in a child process (program "read_field_file" of this
// package, located next to the running program) that is killed at its deadline:
// damaged NetCDF-4 files can hang or crash the library.

#ifndef KG_BASE_RASTER_FIELD_CHILD_H_
#define KG_BASE_RASTER_FIELD_CHILD_H_

#include <string>
#include <vector>

#include "kg_base/raster/field_file.h"

namespace kg_base {

// As ReadFieldFile and ReadVariable (read_field_file.h). Throws InputError as
// they do, and when the process crashes or passes its deadline.
FieldFile ReadFieldFileSafely(const std::string& path,
                              const std::vector<FieldQuantity>& quantities,
                              double deadline_s = 30.0);
FieldFile ReadVariableSafely(const std::string& path,
                             const std::string& variable,
                             double deadline_s = 30.0);

}  // namespace kg_base

#endif  // KG_BASE_RASTER_FIELD_CHILD_H_
