// A scalar in time slices on the grid of a velocity field (vector_field.h), for
// quantities that have a cost along a path, such as wave height. SI units; NaN
// = no data.
//
// Bilinear between cell centres over the corners that have data, linear in time
// between slices; before the first and after the last slice the nearest
// applies.

#ifndef KG_BASE_RASTER_SCALAR_FIELD_H_
#define KG_BASE_RASTER_SCALAR_FIELD_H_

#include <string>
#include <vector>

#include "kg_base/raster/grid.h"
#include "kg_base/raster/shared_raster.h"

namespace kg_base {

struct ScalarSlice {
  double time_s = 0.0;  // Unix seconds.
  SharedRaster values;
};

struct ScalarField {
  std::string quantity;  // Name in source_quantities.h: "wave_height".
  std::vector<ScalarSlice> slices;  // Ascending in time.

  // Value at `point` (in cell units of `grid`). 0 where unknown: off the grid,
  // or without data at all four corners.
  double Sample(const Grid& grid, GridPoint point, double time_s) const;
};

}  // namespace kg_base

#endif  // KG_BASE_RASTER_SCALAR_FIELD_H_
