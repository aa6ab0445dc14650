// Facts that are accepted but have no effect, such as an area off the grid or
// an event on land, and agents that cannot start: found in a compiled mission,
// with the cause and the remedy. Used by `kg validate`, by reports on updates,
// the log and the diagnostics of the node.

#ifndef KG_COMPILER_EXPLAIN_FACT_WARNINGS_H_
#define KG_COMPILER_EXPLAIN_FACT_WARNINGS_H_

#include <string>
#include <vector>

#include "kg_compiler/compile/mission_compiler.h"

namespace kg_compiler {

// One line each, in the order of the mission's facts: the fact, why it has no
// effect in any compiled window in which it applies, and what to do. Covers
//  - the land of the work field, if every cell has data;
//  - constraints that meet no cell with data: off the grid, on land, and soft
//    ones that contain no cell's centre;
//  - priors, likewise (of rasters those that some policy weighs);
//  - events whose radius meets no open cell of any agent;
//  - the agents of FindClosedStarts.
std::vector<std::string> FindWarnings(const Compilation& compilation);

// One line for each agent that starts off the grid, on land, or where a no_go
// area or its buffer forbids it, naming the constraints.
std::vector<std::string> FindClosedStarts(const Compilation& compilation);

}  // namespace kg_compiler

#endif  // KG_COMPILER_EXPLAIN_FACT_WARNINGS_H_
