// Distances of cells to a set of cells, in cells (land buffers, A15) and in
// metres (hazard, soft edges of priors).

#ifndef KG_COMPILER_DATA_PLANE_DISTANCE_TRANSFORM_H_
#define KG_COMPILER_DATA_PLANE_DISTANCE_TRANSFORM_H_

#include "kg_base/raster/grid.h"
#include "kg_mission/mission/mission.h"

namespace kg_compiler {

// Cells within `cells` of a cell of `set`, a mask of rows x cols: distance
// between centres in cell units <= `cells` (A15), Euclidean or the larger of
// the two differences (Chebyshev). Includes the set itself; growing by 0
// returns the set.
kg_base::Mask GrowByCells(
    int rows, int cols, const kg_base::Mask& set, double cells,
    kg_mission::BufferMetric metric = kg_mission::BufferMetric::kEuclidean);
inline kg_base::Mask GrowByCells(
    const kg_base::Grid& grid, const kg_base::Mask& set, double cells,
    kg_mission::BufferMetric metric = kg_mission::BufferMetric::kEuclidean) {
  return GrowByCells(grid.rows(), grid.cols(), set, cells, metric);
}

// Metres from each cell's centre to the nearest centre of the set, 0 inside;
// infinite if the set is empty. Eastward distances at the scale of the set's
// row: d^2 = min over rows r' of (dx(r', col)^2 + dy(row, r')^2), exact along
// rows and columns. Lower envelope of parabolas: Felzenszwalb and Huttenlocher,
// "Distance Transforms of Sampled Functions", Theory of Computing 8, 2012.
std::vector<double> DistanceTo_m(const kg_base::Grid& grid,
                                 const kg_base::Mask& set);

}  // namespace kg_compiler

#endif  // KG_COMPILER_DATA_PLANE_DISTANCE_TRANSFORM_H_
