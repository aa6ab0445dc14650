// The navigation graph of one (agent, window), from the places the agent may be
// at when the window begins.

#ifndef KG_COMPILER_CONTROL_PLANE_WINDOW_GRAPH_H_
#define KG_COMPILER_CONTROL_PLANE_WINDOW_GRAPH_H_

#include <string>
#include <vector>

#include "kg_compiler/control_plane/nav_graph.h"

namespace kg_compiler {

struct WindowInputs {
  const SeamRules* rules = nullptr;
  const WindowRules* window = nullptr;
  WindowWorld world;
  std::vector<kg_core::LonLat> sources;
};

// Of all that BuildWindowGraph reads.
std::string WindowGraphHash(const WindowInputs& inputs);

// Waypoints by descending score, then row, then column; edges by (from, to).
// Both empty if the agent cannot be anywhere.
NavGraph BuildWindowGraph(const WindowInputs& inputs);

// May one be here in this window? False on land, in a no_go area, off the grid.
bool IsOpenAt(const MissionTensor& tensor, kg_core::LonLat position);

}  // namespace kg_compiler

#endif  // KG_COMPILER_CONTROL_PLANE_WINDOW_GRAPH_H_
