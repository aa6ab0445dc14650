// Values of coordinate variables: unpacked and checked.
// Source: CF-1.8, section 8.1; the NetCDF users' guide on packed data.

#ifndef KG_BASE_RASTER_COORDINATE_VALUES_H_
#define KG_BASE_RASTER_COORDINATE_VALUES_H_

#include <vector>

#include "kg_base/raster/netcdf_file.h"

namespace kg_base {

// The single finite number of an attribute; `absent` if there is none. Throws
// InputError.
double SingleNumber(const NetcdfFile& file, const NetcdfVariable& variable,
                    const std::string& attribute, double absent);

// scale_factor and add_offset applied. Throws InputError.
std::vector<double> UnpackedValues(const NetcdfFile& file,
                                   const NetcdfVariable& variable);

// Likewise of a variable with one dimension or none, of which all values must
// be present. Throws InputError.
std::vector<double> CoordinateValues(const NetcdfFile& file,
                                     const NetcdfVariable& axis);

}  // namespace kg_base

#endif  // KG_BASE_RASTER_COORDINATE_VALUES_H_
