// Finds quantities among the variables of a gridded file.
// Source: CF-1.8, section 3.3 (standard names).

#ifndef KG_BASE_RASTER_FIND_VARIABLES_H_
#define KG_BASE_RASTER_FIND_VARIABLES_H_

#include <string>
#include <vector>

#include "kg_base/raster/field_quantity.h"
#include "kg_base/raster/netcdf_file.h"

namespace kg_base {

struct FoundVariable {
  const NetcdfVariable* variable = nullptr;
  std::vector<std::string> warnings;  // Other candidates.
};

// The variable of each quantity: by standard_name in the order of its words,
// then, among variables that have none and whose long_name does not contradict,
// by name. Throws InputError that lists the missing ones, the names tried and
// what is there.
std::vector<FoundVariable> FindVariables(
    const NetcdfFile& file, const std::vector<FieldQuantity>& quantities);

}  // namespace kg_base

#endif  // KG_BASE_RASTER_FIND_VARIABLES_H_
