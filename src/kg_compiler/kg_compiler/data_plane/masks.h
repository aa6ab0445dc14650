// Constraints on the grid: where one may be at all (M_hard), and how much less
// a place is worth (M_soft).

#ifndef KG_COMPILER_DATA_PLANE_MASKS_H_
#define KG_COMPILER_DATA_PLANE_MASKS_H_

#include <vector>

#include "kg_compiler/data_plane/active_facts.h"
#include "kg_core/raster/grid.h"

namespace kg_compiler {

// M_hard: 1 = open. 0 on land, in every cell that a hard area touches
// (supercover, A15) and within its buffer, or the land's (Euclidean, in cells).
kg_core::Mask OpenCells(const kg_core::Grid& grid, const kg_core::Mask& land,
                        const std::vector<ActiveConstraint>& constraints);

// M_soft: the product of the factors of the soft zones that a cell's centre is
// in (A10), or in whose buffer it is. 1 elsewhere.
std::vector<double> Attenuations(
    const kg_core::Grid& grid, const kg_core::Mask& land,
    const std::vector<ActiveConstraint>& constraints);

// 1 in the cells that one constraint holds in, its buffer included.
kg_core::Mask ConstraintExtent(const kg_core::Grid& grid,
                               const kg_core::Mask& land,
                               const ActiveConstraint& constraint);

}  // namespace kg_compiler

#endif  // KG_COMPILER_DATA_PLANE_MASKS_H_
