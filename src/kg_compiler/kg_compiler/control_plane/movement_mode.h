// How an agent moves within a window.

#ifndef KG_COMPILER_CONTROL_PLANE_MOVEMENT_MODE_H_
#define KG_COMPILER_CONTROL_PLANE_MOVEMENT_MODE_H_

#include <string>

namespace kg_compiler {

// How an agent moves within a window (A22).
enum class MovementMode {
  kHops,   // One waypoint per window, then one of the next.
  kEdges,  // Also along edges between the waypoints of a window.
};
const char* Name(MovementMode mode);  // "hops", "edges".
// Throws kg_base::InputError for another name.
MovementMode MovementModeOf(const std::string& name);

}  // namespace kg_compiler

#endif  // KG_COMPILER_CONTROL_PLANE_MOVEMENT_MODE_H_
