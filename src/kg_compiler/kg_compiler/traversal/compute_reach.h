// Reachable set of a voyage: the fan of extremals, run to the deadline.

#ifndef KG_COMPILER_TRAVERSAL_COMPUTE_REACH_H_
#define KG_COMPILER_TRAVERSAL_COMPUTE_REACH_H_

#include "kg_compiler/traversal/reach.h"
#include "kg_compiler/traversal/voyage.h"

namespace kg_compiler {

// Cells reachable before the deadline at full speed. Empty if the departure
// itself is not in an open cell, or the voyage is not well-formed.
ReachMap ComputeReach(const VoyageRequest& voyage);

}  // namespace kg_compiler

#endif  // KG_COMPILER_TRAVERSAL_COMPUTE_REACH_H_
