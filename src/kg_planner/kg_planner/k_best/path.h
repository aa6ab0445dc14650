// Types shared by the searches in this folder: a path through a trellis, and
// masks that forbid nodes and seams. Costs and rewards in the units of the
// trellis.

#ifndef KG_PLANNER_K_BEST_PATH_H_
#define KG_PLANNER_K_BEST_PATH_H_

#include <vector>

namespace kg_planner {

struct Path {
  std::vector<int> nodes;  // One per stage.
  double reward = 0.0;     // Includes stops on the way; each token once.
  double cost = 0.0;
  double resource = 0.0;
  std::vector<double> more_resources = {};
  std::vector<int> seams = {};  // Index in the stage's seams, one per stage.
  double score() const { return reward - cost; }
};

// Nodes and seams a path may not use. A masked node is not used as a stop
// either; among parallel seams a seam mask refers to the one with exactly
// `via`.
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
