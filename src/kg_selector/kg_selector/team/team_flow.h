// The exact plan of agents that are alike but for where they start: each wants
// one node a stage, each node takes so many of them.
//
//   maximise  sum of rewards of nodes visited - sum of seam costs
//
// A minimum-cost flow on the trellis with every node split in two, one unit an
// agent: successive shortest paths [1] by Dijkstra's algorithm on costs reduced
// by potentials, which a first pass through the stages gives. At most agents *
// seams steps. Exact but for rounding; deterministic.
// As many agents are served as the capacities allow.
//
// [1] R. K. Ahuja, T. L. Magnanti and J. B. Orlin, "Network Flows", 1993, 9.7.

#ifndef KG_SELECTOR_TEAM_TEAM_FLOW_H_
#define KG_SELECTOR_TEAM_TEAM_FLOW_H_

#include <cstddef>
#include <vector>

namespace kg_selector {

struct FlowSeam {
  int from = 0;  // Node of the stage before; the agent, if it is the first.
  int to = 0;
  double cost = 0.0;
};

struct FlowStage {
  std::vector<double> rewards;  // By node.
  std::vector<int> capacities;  // By node, >= 0.
  std::vector<FlowSeam> seams;  // Into this stage.
};

struct TeamFlow {
  int agents = 0;
  std::vector<FlowStage> stages;
};

struct FlowPlan {
  // By agent its node of every stage; empty = it has none.
  std::vector<std::vector<int>> nodes;
  double value = 0.0;
};

// Throws std::invalid_argument naming the stage if an index is out of range or
// a number not finite.
FlowPlan SolveFlow(const TeamFlow& flow);

}  // namespace kg_selector

#endif  // KG_SELECTOR_TEAM_TEAM_FLOW_H_
