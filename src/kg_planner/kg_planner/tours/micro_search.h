// Anytime search for micro-paths: destroy and repair of paths already found.

#ifndef KG_PLANNER_TOURS_MICRO_SEARCH_H_
#define KG_PLANNER_TOURS_MICRO_SEARCH_H_

#include <chrono>
#include <vector>

#include "kg_planner/tours/micro_graph.h"
#include "kg_planner/tours/micro_problem.h"

namespace kg_planner {

// Returns `paths` and all paths found, each (set, end) in its best order found.
// Steps and seed as in MicroPathOptions; stops at `deadline`.
std::vector<MicroPath> ImproveMicroPaths(
    const MicroGraph& graph, std::vector<MicroPath> paths,
    const MicroPathOptions& options,
    std::chrono::steady_clock::time_point deadline);

}  // namespace kg_planner

#endif  // KG_PLANNER_TOURS_MICRO_SEARCH_H_
