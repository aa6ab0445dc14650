// Walks: ways through a window that visit several of its waypoints (movement
// mode "edges", A22).
//
// From every source place, the planner searches for good micro-paths
// (kg_planner/tours/micro_paths.h): the edge into the window, then inner edges,
// with rewards minus leg costs. The search takes durations and costs of legs as
// if flown at the window's begin, which is an estimate. Each walk found is
// therefore flown as a whole, along the tracks of its edges from its true
// departure times, until the deadline; infeasible ones are dropped. Its S is
// that of one edge with this flight (nav_graph.h), and it is added to the graph
// as an edge of its own, with `via`, beside the direct one:
//
//   R = sum of the waypoints' scores + each event once
//   S = SeamCost(time, energy, hazard, isolation of the end place, turn at
//                the start)
//
// Legs are flown at the speeds of their edges, which were optimised for a
// single leg, or all at cruise speed if the walk does not fit into the window
// otherwise.
//
// Kept are walks that are worth more than the direct edge to the same end and
// than other orders of the same stops: at most kWalksPerEnd per pair of source
// and end, plus as many that do not need the events' rewards, which other
// agents may take. The limit bounds the search; it is not a rule of the
// mission.

#ifndef KG_SELECTOR_PATHS_WALKS_H_
#define KG_SELECTOR_PATHS_WALKS_H_

#include <vector>

#include "kg_compiler/control_plane/nav_graphs.h"
#include "kg_compiler/control_plane/seam_cache.h"
#include "kg_compiler/control_plane/seam_rules.h"
#include "kg_selector/paths/pathlet.h"

namespace kg_selector {

inline constexpr int kWalksPerEnd = 2;
inline constexpr int kMaxStops = 5;  // Stops per walk, its end included.

// Inputs for one window of an agent in mode "edges".
struct WalkInputs {
  const kg_compiler::SeamRules* rules = nullptr;
  const kg_compiler::WindowRules* window = nullptr;
  kg_compiler::WindowWorld world;
  const kg_compiler::NavGraph* graph = nullptr;  // Without walks.
  std::vector<kg_base::LonLat> sources;  // Places, by TraverseEdge::from.
};

// Maximum number of walks per pair of source and end.
struct WalkOptions {
  int per_end = kWalksPerEnd;
  int max_stops = kMaxStops;
};

// The walks, sorted by (from, to, via). Deterministic.
std::vector<kg_compiler::TraverseEdge> FindWalks(const WalkInputs& inputs,
                                                 const WalkOptions& options);

// The walk from inputs.sources[from] through waypoints, the last of which is
// its end; nullopt if an edge is missing or the walk cannot be flown.
std::optional<kg_compiler::TraverseEdge> FlyWalk(const WalkInputs& inputs,
                                                 int from,
                                                 const std::vector<int>& stops);

// Data kept between planning calls for one agent.
struct GraphCache {
  kg_compiler::SeamCache seams;
  kg_compiler::NavGraphs walked;  // Graphs of the last call, with walks.
  int windows_walked = 0;  // Windows searched for walks in the last call.
};

// The graphs the agent plans on: CompileNavGraphs, with walks added in mode
// "edges". `cache` (may be null) as in CompileNavGraphs: walks of an unchanged
// graph are reused; the result is bitwise identical without it. Throws as
// CompileNavGraphs does.
kg_compiler::NavGraphs CompileWalkedGraphs(
    const kg_compiler::SeamRules& rules,
    const std::vector<kg_compiler::WindowWorld>& worlds, GraphCache* cache);

}  // namespace kg_selector

#endif  // KG_SELECTOR_PATHS_WALKS_H_
