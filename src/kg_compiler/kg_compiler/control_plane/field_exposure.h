// Exposure of a flight to the fields that have a cost (wave height, ...):
//
//   X = int_departure^arrival field(x(t), t) dt        [unit s]
//
// x(t) is linear between the points of the track, which are close enough to
// represent the flown path. Midpoint rule with steps of at most kStep_cells and
// kStep_s; exact for a field that is linear along a leg. Unknown values count
// as 0 (scalar_field.h).

#ifndef KG_COMPILER_CONTROL_PLANE_FIELD_EXPOSURE_H_
#define KG_COMPILER_CONTROL_PLANE_FIELD_EXPOSURE_H_

#include <vector>

#include "kg_base/raster/vector_field.h"
#include "kg_compiler/traversal/voyage.h"

namespace kg_compiler {

// Exposure per entry of kg_mission's CostQuantities(), in their order; 0 for
// those that `field` does not have. Empty if it has none.
std::vector<double> FieldExposures(const kg_base::VectorField& field,
                                   const FlownPath& flight);

}  // namespace kg_compiler

#endif  // KG_COMPILER_CONTROL_PLANE_FIELD_EXPOSURE_H_
