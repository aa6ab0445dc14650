// Two compilations held against each other, bit by bit: what is made step by
// step must be what is made anew.

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
  std::vector<std::string> differs;  // Those that differ, by name.
};

// Work fields, tensors with all their layers, seam rules and coordination; what
// only one of them has, differs. Times, the dirty set and the world version do
// not count.
Difference Compare(const Compilation& a, const Compilation& b);

// One agent's graphs: waypoints, edges and their flights.
Difference Compare(const NavGraphs& a, const NavGraphs& b);

}  // namespace kg_compiler

#endif  // KG_COMPILER_COMPILE_SAME_COMPILATION_H_
