// A scalar in time slices on the grid of a velocity field (vector_field.h):
// what is met under way and costs, such as the height of waves. SI units; NaN =
// no data.
//
// Between cell centres bilinear over the corners that have data, between slices
// linear in time; before the first and after the last slice the nearest holds.

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
  std::string quantity;             // Of source_quantities.h: "wave_height".
  std::vector<ScalarSlice> slices;  // Ascending in time.

  // `point` in cell units of `grid`. 0 where nothing is known: off the grid,
  // or without data at all four corners.
  double Sample(const Grid& grid, GridPoint point, double time_s) const;
};

}  // namespace kg_base

#endif  // KG_BASE_RASTER_SCALAR_FIELD_H_
