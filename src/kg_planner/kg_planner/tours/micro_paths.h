// Several nodes visited within one stage: orienteering inside the stage's
// duration. From one place of entry, for every node where the stage may end,
// the best path through nodes of the stage and good-enough alternatives.
//
//   maximise  score = sum of rewards of the nodes visited - sum of leg costs
//   such that the durations of the legs add up to at most `duration_limit`
//
// Each node at most once; of a token the largest reward met, once. Alternatives
// differ in the set of nodes they visit: of each set and end only the best
// order is given (least cost, then duration, then resource, then node numbers).
//
// Exact: labels over (set visited, end), one dominating another if neither its
// cost nor its duration is larger [1]. If more than `exact_labels` are needed,
// an anytime search instead: labels in a beam, then destroy and repair of the
// paths found, for `max_steps` steps. Steps give the same bits wherever it
// runs; a deadline does not, and is infinite unless asked for.
//
// Example: from the entry, 0 and 1 take an hour each, between them half an
// hour: with a limit of two hours {0}, {1}, {0, 1} and {1, 0} are possible.
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
