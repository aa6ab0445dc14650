// Several nodes visited within one stage: orienteering within the stage's
// duration. From one entry, for every node where the stage may end, the best
// path through nodes of the stage and good-enough alternatives.
//
//   maximise  score = sum of rewards of the nodes visited - sum of leg costs
//   such that the durations of the legs add up to at most `duration_limit`
//
// Each node at most once; of each token the largest reward met counts, once.
// Alternatives differ in the set of nodes they visit: of each (set, end) only
// the best order is returned (least cost, then duration, then resource, then
// node numbers).
//
// Exact search: labels over (set visited, end), one dominating another if
// neither its cost nor its duration is larger [1]. If more than `exact_labels`
// are needed, an anytime search is used instead: labels in a beam, then destroy
// and repair of the paths found, for `max_steps` steps. A step limit gives
// bitwise reproducible results on any machine; a deadline does not, and is
// infinite by default.
//
// Example: legs from the entry to 0 and 1 take one hour each, those between
// them half an hour: with a limit of two hours {0}, {1}, {0, 1} and {1, 0} are
// feasible.
//
// [1] D. Feillet et al., "An Exact Algorithm for the Elementary Shortest Path
//     Problem with Resource Constraints", Networks 44 (2004), 216-229.

#ifndef KG_PLANNER_TOURS_MICRO_PATHS_H_
#define KG_PLANNER_TOURS_MICRO_PATHS_H_

#include "kg_planner/tours/micro_problem.h"

namespace kg_planner {

// Throws std::invalid_argument that names node or leg if an index is out of
// range, a number is not finite, a cost, resource or duration is negative, a
// pair occurs twice, or an option is out of its range.
MicroPaths FindMicroPaths(const StageProblem& problem,
                          const MicroPathOptions& options);

}  // namespace kg_planner

#endif  // KG_PLANNER_TOURS_MICRO_PATHS_H_
