// The values of a gridded file's variable in SI: unpacking, fill values and
// units. Source: CF-1.8, sections 2.5.1, 3.1 and 8.1.

#ifndef KG_BASE_RASTER_FIELD_VALUES_H_
#define KG_BASE_RASTER_FIELD_VALUES_H_

#include <string>
#include <vector>

#include "kg_base/raster/field_axes.h"
#include "kg_base/raster/field_file.h"
#include "kg_base/raster/netcdf_file.h"

namespace kg_base {

// One raster for each time, with a report. Missing: _FillValue and
// missing_value as number or text, in the variable's type or another precision,
// the type's default fill, NaN. Values outside the valid range
// (field_quantity.h) are treated as missing; a variable where most are outside,
// or without any value, is rejected; a time without any value is reported. For
// FieldQuantity::kAny any finite value is valid except an undeclared fill,
// which is rejected.
QuantitySeries ReadSeries(const NetcdfFile& file, const FieldAxes& axes,
                          const NetcdfVariable& variable,
                          FieldQuantity quantity);

}  // namespace kg_base

#endif  // KG_BASE_RASTER_FIELD_VALUES_H_
