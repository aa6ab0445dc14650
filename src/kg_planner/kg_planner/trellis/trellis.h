// The planner's model of the world: stages of nodes with rewards, and seams
// between consecutive stages with costs.
//
//   maximise  J = sum of rewards of the nodes visited - sum of seam costs
//
// with one node per stage, from the start through every stage. A token is a
// reward that several nodes offer but a path earns once. Resources are used by
// seams and limited over the whole path.
//
// A seam may visit nodes of its stage on the way (`via`): the path earns their
// rewards and tokens too. Hence a pair of nodes may have several seams.

#ifndef KG_PLANNER_TRELLIS_TRELLIS_H_
#define KG_PLANNER_TRELLIS_TRELLIS_H_

#include <limits>
#include <vector>

namespace kg_planner {

struct TokenReward {
  int token = 0;        // Id, unique over the whole trellis.
  double reward = 0.0;  // >= 0; a path earns the largest it meets, once.
};

struct Node {
  double reward = 0.0;
  std::vector<TokenReward> tokens;
};

struct Seam {
  int from = 0;           // Node of the previous stage; 0 = the start.
  int to = 0;             // Node of this stage.
  double cost = 0.0;      // >= 0.
  double resource = 0.0;  // >= 0.
};

struct Stage {
  std::vector<Node> nodes;
  std::vector<Seam> seams;  // Into this stage; one per (from, to, via).
  // By seam: nodes of this stage visited on the way; empty = no seam of this
  // stage has stops.
  std::vector<std::vector<int>> via = {};
  // Use of each resource after the first, by seam, >= 0; as many as
  // `more_limits`.
  std::vector<std::vector<double>> more_resources = {};
};

struct Trellis {
  std::vector<Stage> stages;
  // Limit of the sum over a path's seams, added in path order.
  double resource_limit = std::numeric_limits<double>::infinity();
  std::vector<double> more_limits =
      {};  // Limits of the resources after the first.
};

}  // namespace kg_planner

#endif  // KG_PLANNER_TRELLIS_TRELLIS_H_
