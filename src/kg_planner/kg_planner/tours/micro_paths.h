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

#include <cstddef>
#include <limits>
#include <vector>

#include "kg_planner/trellis/trellis.h"

namespace kg_planner {

struct Leg {
  int from = -1;          // -1: where one enters.
  int to = 0;             // Node of the stage.
  double cost = 0.0;      // >= 0.
  double resource = 0.0;  // >= 0; added up, not limited here.
  double duration = 0.0;  // >= 0.
};

struct StageProblem {
  std::vector<Node> nodes;
  std::vector<Leg> legs;  // Entries and inner legs, one per (from, to).
  double duration_limit = 0.0;
};

struct MicroPath {
  std::vector<int> nodes;  // In the order visited; the last is the end.
  double reward = 0.0;     // With tokens, each earned once.
  double cost = 0.0;
  double resource = 0.0;
  double duration = 0.0;
  double score() const { return reward - cost; }
};

struct MicroPathOptions {
  int per_end = 3;  // Paths per end node, at most; a direct leg comes on top.
  // Of the best score of the same end, at least: in [0, 1].
  double good_enough = 0.9;
  int max_nodes = 8;  // Of one path, with its end.
  std::size_t exact_labels = 20000;
  std::size_t max_steps = 2000;  // Of the search beyond that.
  double deadline_s = std::numeric_limits<double>::infinity();  // Wall clock.
  unsigned seed = 1;
};

struct MicroPaths {
  // By end node; of the same end the best first. A direct leg that keeps the
  // limit is always among them, however poor.
  std::vector<MicroPath> paths;
  bool proven = true;  // False: not all labels were looked at.
};

// Throws std::invalid_argument that names node or leg if an index is out of
// range, a number is not finite, a cost, resource or duration is negative, a
// pair occurs twice, or an option is out of its range.
MicroPaths FindMicroPaths(const StageProblem& problem,
                          const MicroPathOptions& options);

}  // namespace kg_planner

#endif  // KG_PLANNER_TOURS_MICRO_PATHS_H_
