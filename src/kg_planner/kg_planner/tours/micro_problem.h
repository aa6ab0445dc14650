// Types of the search for paths within one stage (micro_paths.h): the problem,
// its options and its result. Costs and rewards in the units of the trellis;
// durations in any one unit, e.g. seconds.

#ifndef KG_PLANNER_TOURS_MICRO_PROBLEM_H_
#define KG_PLANNER_TOURS_MICRO_PROBLEM_H_

#include <cstddef>
#include <limits>
#include <vector>

#include "kg_planner/trellis/trellis.h"

namespace kg_planner {

struct Leg {
  int from = -1;          // -1 = the entry.
  int to = 0;             // Node of the stage.
  double cost = 0.0;      // >= 0.
  double resource = 0.0;  // >= 0; summed, not limited here.
  double duration = 0.0;  // >= 0.
};

struct StageProblem {
  std::vector<Node> nodes;
  std::vector<Leg> legs;  // Entries and inner legs, one per (from, to).
  double duration_limit = 0.0;
};

struct MicroPath {
  std::vector<int> nodes;  // In visiting order; the last is the end.
  double reward = 0.0;     // Tokens included, each once.
  double cost = 0.0;
  double resource = 0.0;
  double duration = 0.0;
  double score() const { return reward - cost; }
};

struct MicroPathOptions {
  int per_end = 3;  // Maximum paths per end node, in addition to a direct leg.
  // Minimum share of the best score of the same end; in [0, 1].
  double good_enough = 0.9;
  int max_nodes = 8;  // Maximum nodes of one path, end included.
  std::size_t exact_labels = 20000;
  std::size_t max_steps = 2000;  // Steps of the anytime search.
  double deadline_s = std::numeric_limits<double>::infinity();  // Wall clock.
  unsigned seed = 1;
};

struct MicroPaths {
  // Sorted by end node, then best first. A feasible direct leg is always
  // included, whatever its score.
  std::vector<MicroPath> paths;
  bool proven = true;  // False: the search was not exhaustive.
};

}  // namespace kg_planner

#endif  // KG_PLANNER_TOURS_MICRO_PROBLEM_H_
