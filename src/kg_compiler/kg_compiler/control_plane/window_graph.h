// Builds the navigation graph of one (agent, window) from the places where the
// agent may be when the window begins.

#ifndef KG_COMPILER_CONTROL_PLANE_WINDOW_GRAPH_H_
#define KG_COMPILER_CONTROL_PLANE_WINDOW_GRAPH_H_

#include <memory>
#include <string>
#include <vector>

#include "kg_compiler/control_plane/seam_cache.h"
#include "kg_compiler/control_plane/seam_rules.h"
#include "kg_compiler/control_plane/waypoint_graph.h"

namespace kg_compiler {

struct WindowInputs {
  const SeamRules* rules = nullptr;
  const WindowRules* window = nullptr;
  WindowWorld world;
  std::vector<kg_base::LonLat> sources;
};

// Hash of all inputs that BuildWindowGraph reads.
std::string WindowGraphHash(const WindowInputs& inputs);

// A graph, and the seams that the next graph of this window may reuse.
struct BuiltWindow {
  NavGraph graph;
  std::shared_ptr<const KeptSeams> seams;
};

// Waypoints by descending score, then row, then column; edges by (from, to).
// Both empty if the agent cannot be anywhere. `last` may be null.
BuiltWindow BuildWindowGraph(const WindowInputs& inputs, const KeptSeams* last,
                             SeamCounts* counts);

// May an agent be at this position in this window? False on land, in a no_go
// area and off the grid.
bool IsOpenAt(const MissionTensor& tensor, kg_base::LonLat position);

}  // namespace kg_compiler

#endif  // KG_COMPILER_CONTROL_PLANE_WINDOW_GRAPH_H_
