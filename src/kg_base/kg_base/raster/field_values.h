// Finds a quantity in a gridded file and converts its values to SI: unpacking,
// fill values and units. Source: CF-1.8, sections 2.5.1, 3.1, 3.3 and 8.1.

#ifndef KG_BASE_RASTER_FIELD_VALUES_H_
#define KG_BASE_RASTER_FIELD_VALUES_H_

#include <string>
#include <vector>

#include "kg_base/raster/field_axes.h"
#include "kg_base/raster/field_file.h"
#include "kg_base/raster/netcdf_file.h"

namespace kg_base {

// The variable of each quantity: by standard_name, then, among variables that
// have none, by name. Throws InputError that lists the missing ones and the
// names tried.
std::vector<const NetcdfVariable*> FindVariables(
    const NetcdfFile& file, const std::vector<FieldQuantity>& quantities);

// One raster for each time. Missing: _FillValue and missing_value (compared
// before unpacking, in the variable's own type), the type's default fill, NaN.
// Values outside the valid range (field_quantity.h) are treated as missing; a
// variable where most are outside, or a time without any value, is rejected.
// For FieldQuantity::kAny any finite value is valid, and a time may be empty.
QuantitySeries ReadSeries(const NetcdfFile& file, const FieldAxes& axes,
                          const NetcdfVariable& variable,
                          FieldQuantity quantity);

}  // namespace kg_base

#endif  // KG_BASE_RASTER_FIELD_VALUES_H_
