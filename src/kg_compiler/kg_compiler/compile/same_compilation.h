// Bitwise comparison of two compilations: an incremental one must equal one
// from scratch.

#ifndef KG_COMPILER_COMPILE_SAME_COMPILATION_H_
#define KG_COMPILER_COMPILE_SAME_COMPILATION_H_

#include <cstddef>
#include <string>
#include <vector>

#include "kg_compiler/compile/mission_compiler.h"
#include "kg_compiler/control_plane/nav_graphs.h"

namespace kg_compiler {

struct Difference {
  std::size_t compared = 0;          // Artifacts.
  std::vector<std::string> differs;  // Names of artifacts that differ.
};

// Compares work fields, tensors with all layers, seam rules and coordination;
// artifacts in only one of them count as different. Times, the dirty set and
// the world version are ignored.
Difference Compare(const Compilation& a, const Compilation& b);

// Compares one agent's graphs: waypoints, edges and their flights.
Difference Compare(const NavGraphs& a, const NavGraphs& b);

}  // namespace kg_compiler

#endif  // KG_COMPILER_COMPILE_SAME_COMPILATION_H_
