// Facts that are accepted but have no effect, such as an area off the grid or
// an event on land, and agents that cannot start: found in a compiled mission,
// with the cause and the remedy. Used by `kg validate`, by reports on updates,
// the log and the diagnostics of the node.

#ifndef KG_COMPILER_EXPLAIN_FACT_WARNINGS_H_
#define KG_COMPILER_EXPLAIN_FACT_WARNINGS_H_

#include <optional>
#include <string>
#include <vector>

#include "kg_base/geo/lon_lat.h"
#include "kg_compiler/compile/mission_compiler.h"

namespace kg_compiler {

struct FactWarning {
  std::string label;  // For a map: "ex:zone has no effect".
  // The label, the cause and the remedy.
  std::string line;
  // Where it lies: the middle of an area. Nullopt for rasters and land.
  std::optional<kg_base::LonLat> place;
};

// In the order of the mission's facts: those that have no effect in any
// compiled window in which they apply. Covers
//  - the land of the work field, if every cell has data;
//  - constraints that meet no cell with data: off the grid, on land, and soft
//    ones that contain no cell's centre;
//  - priors, likewise (of rasters those that some policy weighs);
//  - events whose radius meets no open cell of any agent;
//  - the agents of FindClosedStarts.
std::vector<FactWarning> FindWarnings(const Compilation& compilation);
std::vector<std::string> Lines(const std::vector<FactWarning>& warnings);

// One line for each agent that starts off the grid, on land, or where a no_go
// area or its buffer forbids it, naming the constraints.
std::vector<std::string> FindClosedStarts(const Compilation& compilation);

}  // namespace kg_compiler

#endif  // KG_COMPILER_EXPLAIN_FACT_WARNINGS_H_
