// What a seam costs its agent, in reward units (seam_rules.h has the equation).

#ifndef KG_COMPILER_CONTROL_PLANE_SEAM_COST_H_
#define KG_COMPILER_CONTROL_PLANE_SEAM_COST_H_

#include "kg_compiler/control_plane/seam_rules.h"
#include "kg_compiler/control_plane/waypoint_graph.h"

namespace kg_compiler {

// S of an edge into a window of confidence w, in reward units.
double SeamCost(const SeamWeights& weights, const TraverseEdge& edge,
                double confidence);

}  // namespace kg_compiler

#endif  // KG_COMPILER_CONTROL_PLANE_SEAM_COST_H_
