// Constraints as whole rasters: the cells that may be entered (M_hard), and the
// attenuation of the value of a place (M_soft). Reference for patches.h, and
// used by explanations.

#ifndef KG_COMPILER_DATA_PLANE_MASKS_H_
#define KG_COMPILER_DATA_PLANE_MASKS_H_

#include <vector>

#include "kg_base/raster/grid.h"
#include "kg_compiler/data_plane/active_facts.h"
#include "kg_compiler/data_plane/window_rasters.h"
#include "kg_mission/mission/mission.h"

namespace kg_compiler {

// Cells by which the grid is extended on every side to find the extent of a
// constraint, so that its buffer also grows from what lies beyond the edges. 0
// without a buffer, and where nothing is known beyond: of land and of masks on
// the mission's grid.
int BufferMargin(const kg_mission::Constraint& constraint,
                 const kg_base::Grid& grid);

// The mask that was read for a constraint, on `extended`, the grid extended by
// BufferMargin. Throws std::logic_error if there is none of that size.
const kg_base::Mask& FindMask(const WindowRasters& rasters,
                              const ActiveConstraint& constraint,
                              const kg_base::Grid& extended);

// M_hard: 1 = open. 0 on land, in every cell that a hard area or a masked cell
// of a hard mask touches (supercover, A15), and within its buffer or the
// land's.
kg_base::Mask OpenCells(const WindowRasters& rasters,
                        const std::vector<ActiveConstraint>& constraints);

// M_soft: the product, or the minimum, of the factors of the soft zones whose
// area or buffer contains the cell's centre (A10). 1 elsewhere.
std::vector<double> Attenuations(
    const WindowRasters& rasters,
    const std::vector<ActiveConstraint>& constraints,
    kg_mission::SoftOverlap overlap);

// 1 in the cells where one constraint applies, including its buffer (Euclidean
// or Chebyshev, in cells), which also grows from beyond the grid. Throws
// std::logic_error if the constraint's mask is not among the rasters.
kg_base::Mask ConstraintExtent(const WindowRasters& rasters,
                               const ActiveConstraint& constraint);

}  // namespace kg_compiler

#endif  // KG_COMPILER_DATA_PLANE_MASKS_H_
