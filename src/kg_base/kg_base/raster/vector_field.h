// A horizontal velocity field on a grid, in time slices: currents, wind,
// traffic flow. East and north components in m/s; NaN = no data (land).
//
// Bilinear between cell centres, linear in time between slices; before the
// first and after the last slice the nearest slice applies. A sample is unknown
// (nullopt) where the cell that contains the position has no data; a missing
// corner of the bilinear square counts as no flow (water at rest along a
// coast).

#ifndef KG_BASE_RASTER_VECTOR_FIELD_H_
#define KG_BASE_RASTER_VECTOR_FIELD_H_

#include <optional>
#include <string>
#include <vector>

#include "kg_base/raster/grid.h"
#include "kg_base/raster/scalar_field.h"
#include "kg_base/raster/shared_raster.h"

namespace kg_base {

struct Velocity {
  double east_mps = 0.0;
  double north_mps = 0.0;
};

// Copies share their rasters.
struct FieldSlice {
  double time_s = 0.0;  // Unix seconds.
  SharedRaster east_mps;
  SharedRaster north_mps;
};

struct VectorField {
  Grid grid;
  std::vector<FieldSlice> slices;  // Ascending in time, at least one.
  // Further quantities on the same grid; usually none.
  std::vector<ScalarField> scalars = {};

  // Velocity at `point` (in cell units of `grid`) and `time_s` (Unix seconds).
  std::optional<Velocity> Sample(GridPoint point, double time_s) const;

  // The slices needed for [begin_s, end_s]: those inside and the next one on
  // either side.
  VectorField Between(double begin_s, double end_s) const;

  // Land mask: 1 where a slice has no data.
  Mask NoData() const;
  double MaxSpeed_mps() const;
  std::string Hash() const;  // Grid, times and values, hex.
};

}  // namespace kg_base

#endif  // KG_BASE_RASTER_VECTOR_FIELD_H_
