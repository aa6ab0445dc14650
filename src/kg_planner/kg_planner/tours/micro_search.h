// Anytime search for micro-paths: destroy and repair of paths already found.

#ifndef KG_PLANNER_TOURS_MICRO_SEARCH_H_
#define KG_PLANNER_TOURS_MICRO_SEARCH_H_

#include <chrono>
#include <vector>

#include "kg_planner/tours/micro_graph.h"
#include "kg_planner/tours/micro_problem.h"

namespace kg_planner {

// `paths` and what was found on the way, each set and end in its best order
// met. Steps and seed as MicroPathOptions says; ends at `deadline` at the
// latest.
std::vector<MicroPath> ImproveMicroPaths(
    const MicroGraph& graph, std::vector<MicroPath> paths,
    const MicroPathOptions& options,
    std::chrono::steady_clock::time_point deadline);

}  // namespace kg_planner

#endif  // KG_PLANNER_TOURS_MICRO_SEARCH_H_
