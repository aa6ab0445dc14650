// Frontness: magnitude of the gradient of a value layer, per km (A14, A16).
//
//   F = sqrt(gx^2 + gy^2),  gx the Sobel-weighted mean (1, 2, 1) of the
//   eastward differences in the rows r-1, r, r+1, gy likewise of the northward
//   differences in the columns; each difference is divided by its length on
//   WGS84.
//
// kCentral uses only the differences in the cell's own row and column.
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

// F in units of `values` per km, computed in double precision; layer_table.h is
// the float32 counterpart for tensors.
kg_base::Raster GradientPerKm(
    const kg_base::Grid& grid, const kg_base::Raster& values,
    kg_mission::FrontOperator op = kg_mission::FrontOperator::kSobel);

}  // namespace kg_compiler

#endif  // KG_COMPILER_DATA_PLANE_FRONTNESS_H_
