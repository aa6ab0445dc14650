// Walks: ways through a window that visit several of its waypoints (movement
// mode "edges", A22).
//
// From every place one can come from, the planner looks for good micro-paths
// (kg_planner/tours/micro_paths.h): the edge into the window, then inner edges,
// their rewards less what the legs cost. There legs last and cost what they do
// when the window begins, which is not when one really gets there. So each walk
// found is then flown as a whole, along the tracks of its edges from its true
// departure times, until the deadline; what cannot be flown so is left out. Its
// S is that of one edge with this flight (nav_graph.h), and it stands in the
// graph as an edge of its own, with `via`, beside the direct one:
//
//   R = sum of the waypoints' scores, and each event once
//   S = SeamCost(time, energy, hazard, isolation of the end place)
//
// Legs go at the speeds of their edges, which were chosen by price for one leg;
// or all at cruise speed, where a walk does not fit into the window otherwise.
//
// Kept are walks that are worth more than the direct edge to the same end and
// than other orders of the same stops: at most kWalksPerEnd for each place one
// comes from and end, and as many that do without the events' rewards, which
// others may take. A planner need not find more: it limits the search, not what
// is possible.

#ifndef KG_SELECTOR_PATHS_WALKS_H_
#define KG_SELECTOR_PATHS_WALKS_H_

#include <vector>

#include "kg_compiler/control_plane/nav_graphs.h"
#include "kg_compiler/control_plane/seam_cache.h"
#include "kg_compiler/control_plane/seam_rules.h"
#include "kg_selector/paths/pathlet.h"

namespace kg_selector {

inline constexpr int kWalksPerEnd = 2;
inline constexpr int kMaxStops = 5;  // Of one walk, its end included.

// One window of an agent in the mode "edges".
struct WalkInputs {
  const kg_compiler::SeamRules* rules = nullptr;
  const kg_compiler::WindowRules* window = nullptr;
  kg_compiler::WindowWorld world;
  const kg_compiler::NavGraph* graph = nullptr;  // Without walks.
  std::vector<kg_base::LonLat> sources;          // By TraverseEdge::from.
};

// How many walks there are of one pair of ends, at most.
struct WalkOptions {
  int per_end = kWalksPerEnd;
  int max_stops = kMaxStops;
};

// The walks, by (from, to, via). Deterministic.
std::vector<kg_compiler::TraverseEdge> FindWalks(const WalkInputs& inputs,
                                                 const WalkOptions& options);

// The walk from inputs.sources[from] through waypoints, the last its end;
// nothing if an edge of it is not there or it cannot be flown.
std::optional<kg_compiler::TraverseEdge> FlyWalk(const WalkInputs& inputs,
                                                 int from,
                                                 const std::vector<int>& stops);

// What planning for one agent keeps from one time to the next.
struct GraphCache {
  kg_compiler::SeamCache seams;
  kg_compiler::NavGraphs walked;  // The last ones, with their walks.
  int windows_walked = 0;  // Windows searched for walks in the last call.
};

// The agent's graphs as it plans by them: CompileNavGraphs, and in the mode
// "edges" with their walks. `cache` (may be null) as there: the walks of a
// graph that did not change are taken over, and the result is the same bits as
// without. Throws as CompileNavGraphs does.
kg_compiler::NavGraphs CompileWalkedGraphs(
    const kg_compiler::SeamRules& rules,
    const std::vector<kg_compiler::WindowWorld>& worlds, GraphCache* cache);

}  // namespace kg_selector

#endif  // KG_SELECTOR_PATHS_WALKS_H_
