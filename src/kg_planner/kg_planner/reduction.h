// Smaller trellises that lose no allowed path: numbers of nodes stay.

#ifndef KG_PLANNER_REDUCTION_H_
#define KG_PLANNER_REDUCTION_H_

#include "kg_planner/k_best.h"
#include "kg_planner/trellis.h"

namespace kg_planner {

// Without the seams that `masks` forbid or that touch a node they forbid; seams
// ascend by (from, to). Throws std::invalid_argument if a mask names a stage or
// node that is not there; a seam mask without a seam forbids nothing.
Trellis ApplyMasks(const Trellis& trellis, const Masks& masks);

// Without the seams that lead nowhere, or that no path within the resource
// limit can use.
Trellis DropUnaffordable(Trellis trellis);

}  // namespace kg_planner

#endif  // KG_PLANNER_REDUCTION_H_
