// Frontness: how steep a value layer is, per kilometre (A14, A16).
//
//   F = sqrt(gx^2 + gy^2),  gx the Sobel-weighted mean (1, 2, 1) of the
//   eastward differences in the rows r-1, r, r+1, gy likewise of the northward
//   differences in the columns; a difference is over its own length on WGS84.
//
// kCentral takes the differences of the cell's own row and column alone.
//
// No data (non-finite): a difference is central where both neighbours have
// data, one-sided where one and the middle have, left out of the mean
// otherwise. NaN where the cell itself has no data; 0 where nothing can be
// differenced.

#ifndef KG_COMPILER_DATA_PLANE_FRONTNESS_H_
#define KG_COMPILER_DATA_PLANE_FRONTNESS_H_

#include "kg_base/raster/grid.h"
#include "kg_mission/mission/mission.h"

namespace kg_compiler {

// In units of `values` per km. Double precision inside; layer_table.h makes the
// same in float32 for tensors.
kg_base::Raster GradientPerKm(
    const kg_base::Grid& grid, const kg_base::Raster& values,
    kg_mission::FrontOperator op = kg_mission::FrontOperator::kSobel);

}  // namespace kg_compiler

#endif  // KG_COMPILER_DATA_PLANE_FRONTNESS_H_
