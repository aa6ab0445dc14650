// Constraints on the grid, whole rasters of them: where one may be at all
// (M_hard), and how much less a place is worth (M_soft). The reference that
// patches.h is held to, and what explanations are made of.

#ifndef KG_COMPILER_DATA_PLANE_MASKS_H_
#define KG_COMPILER_DATA_PLANE_MASKS_H_

#include <vector>

#include "kg_base/raster/grid.h"
#include "kg_compiler/data_plane/active_facts.h"
#include "kg_compiler/data_plane/window_rasters.h"
#include "kg_mission/mission/mission.h"

namespace kg_compiler {

// M_hard: 1 = open. 0 on land, in every cell that a hard area touches
// (supercover, A15) or a hard mask has, and within its buffer, or the land's.
kg_base::Mask OpenCells(const WindowRasters& rasters,
                        const std::vector<ActiveConstraint>& constraints);

// M_soft: the product of the factors of the soft zones that a cell's centre is
// in (A10), or in whose buffer it is, or the least of them. 1 elsewhere.
std::vector<double> Attenuations(
    const WindowRasters& rasters,
    const std::vector<ActiveConstraint>& constraints,
    kg_mission::SoftOverlap overlap);

// 1 in the cells that one constraint holds in, its buffer included (Euclidean
// or Chebyshev, in cells). Throws std::logic_error if the constraint's mask is
// not among the rasters.
kg_base::Mask ConstraintExtent(const WindowRasters& rasters,
                               const ActiveConstraint& constraint);

}  // namespace kg_compiler

#endif  // KG_COMPILER_DATA_PLANE_MASKS_H_
