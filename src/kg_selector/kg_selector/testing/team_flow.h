// Exact plan of agents that differ only in their start: each visits one node
// per stage, and each node has a capacity.
//
//   maximise  sum of rewards of nodes visited - sum of seam costs
//
// Minimum-cost flow on the trellis with every node split in two, one unit per
// agent: successive shortest paths [1] by Dijkstra's algorithm on costs reduced
// by potentials, initialised by one pass through the stages. At most agents *
// seams steps. Exact up to rounding; deterministic. Serves as many agents as
// the capacities allow.
//
// [1] R. K. Ahuja, T. L. Magnanti and J. B. Orlin, "Network Flows", 1993, 9.7.

#ifndef KG_SELECTOR_TESTING_TEAM_FLOW_H_
#define KG_SELECTOR_TESTING_TEAM_FLOW_H_

#include <cstddef>
#include <vector>

namespace kg_selector {

struct FlowSeam {
  int from = 0;  // Node of the previous stage; in the first stage the agent.
  int to = 0;
  double cost = 0.0;
};

struct FlowStage {
  std::vector<double> rewards;  // Reward by node.
  std::vector<int> capacities;  // Capacity by node, >= 0.
  std::vector<FlowSeam> seams;  // Into this stage.
};

struct TeamFlow {
  int agents = 0;
  std::vector<FlowStage> stages;
};

struct FlowPlan {
  // Node of every stage, by agent; empty = not served.
  std::vector<std::vector<int>> nodes;
  double value = 0.0;
};

// Throws std::invalid_argument naming the stage if an index is out of range or
// a number not finite.
FlowPlan SolveFlow(const TeamFlow& flow);

}  // namespace kg_selector

#endif  // KG_SELECTOR_TESTING_TEAM_FLOW_H_
