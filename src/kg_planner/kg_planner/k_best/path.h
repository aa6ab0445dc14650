// Types of every search in this folder: a path through a trellis, and masks,
// which forbid nodes and seams. Costs and rewards in the units of the trellis.

#ifndef KG_PLANNER_K_BEST_PATH_H_
#define KG_PLANNER_K_BEST_PATH_H_

#include <vector>

namespace kg_planner {

struct Path {
  std::vector<int> nodes;  // One a stage.
  double reward = 0.0;     // With stops on the way; each token earned once.
  double cost = 0.0;
  double resource = 0.0;
  std::vector<double> more_resources = {};
  std::vector<int> seams = {};  // Index in the stage's seams, one a stage.
  double score() const { return reward - cost; }
};

// Nodes and seams a path may not use. A node is not used as a stop, either; of
// parallel seams the one over exactly `via` is meant.
struct NodeMask {
  int stage = 0;
  int node = 0;
};
struct SeamMask {
  int stage = 0;  // The stage the seam leads into.
  int from = 0;
  int to = 0;
  std::vector<int> via = {};
};
struct PathMasks {
  std::vector<NodeMask> nodes;
  std::vector<SeamMask> seams;
};

}  // namespace kg_planner

#endif  // KG_PLANNER_K_BEST_PATH_H_
