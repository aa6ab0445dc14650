// Which level of a vertical axis is the surface: where sea and air meet, or the
// ground. Source: CF-1.8, section 4.3 and appendix D.

#ifndef KG_BASE_RASTER_VERTICAL_AXIS_H_
#define KG_BASE_RASTER_VERTICAL_AXIS_H_

#include <cstddef>
#include <string>
#include <vector>

#include "kg_base/raster/netcdf_file.h"

namespace kg_base {

struct SurfaceLevel {
  std::size_t index = 0;
  std::string text;     // "depth = 0.5 m, of 40 levels"
  std::string warning;  // If it is far from the surface; "" otherwise.
};

// The level of `axis` (values: unpacked, at least one) that is nearest to the
// surface for `variable`. Throws InputError that names the axis if that does
// not follow from its attributes.
SurfaceLevel FindSurface(const NetcdfFile& file, const NetcdfVariable& variable,
                         const NetcdfVariable& axis,
                         const std::vector<double>& values);

}  // namespace kg_base

#endif  // KG_BASE_RASTER_VERTICAL_AXIS_H_
