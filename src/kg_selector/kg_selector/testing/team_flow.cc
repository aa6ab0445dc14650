#include "kg_selector/testing/team_flow.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <stdexcept>
#include <string>
#include <utility>

namespace kg_selector {
namespace {

constexpr double kUnreached = std::numeric_limits<double>::infinity();
constexpr int kNone = -1;
constexpr int kThroughNode = -2;  // Parent is the other half of the node.

void CheckStage(const TeamFlow& flow, std::size_t s) {
  const FlowStage& stage = flow.stages[s];
  const std::string where = "stage " + std::to_string(s);
  // Seams of the first stage start at the agents.
  const int before = s == 0
                         ? flow.agents
                         : static_cast<int>(flow.stages[s - 1].rewards.size());
  const int nodes = static_cast<int>(stage.rewards.size());
  if (stage.capacities.size() != stage.rewards.size()) {
    throw std::invalid_argument(where + ": one capacity a node expected");
  }
  for (const double reward : stage.rewards) {
    if (!std::isfinite(reward)) {
      throw std::invalid_argument(where + ": a reward is not finite");
    }
  }
  for (const FlowSeam& seam : stage.seams) {
    if (seam.from < 0 || seam.from >= before || seam.to < 0 ||
        seam.to >= nodes || !std::isfinite(seam.cost)) {
      throw std::invalid_argument(where + ": seam " +
                                  std::to_string(seam.from) + " -> " +
                                  std::to_string(seam.to));
    }
  }
}

// Seams into one stage, sorted by source, and the flow into it.
struct FlowLayer {
  int first_node = 0;  // Vertex of the first node's in half.
  // Index of the first seam, by source; one extra entry at the end.
  std::vector<int> first;
  std::vector<FlowSeam> seams;
  std::vector<double> gain;
  std::vector<int> capacity_left;         // Capacity left, by node.
  std::vector<std::vector<int>> flow_in;  // Seams with flow, by target node.
  int nodes() const { return static_cast<int>(gain.size()); }
  int in(int v) const { return first_node + v; }
  int out(int v) const { return first_node + nodes() + v; }
};

FlowLayer ToLayer(const FlowStage& stage, int before, int first_node) {
  FlowLayer layer;
  layer.first_node = first_node;
  layer.seams = stage.seams;
  const auto earlier = [](const FlowSeam& a, const FlowSeam& b) {
    return a.from < b.from;
  };
  if (!std::is_sorted(layer.seams.begin(), layer.seams.end(), earlier)) {
    std::stable_sort(layer.seams.begin(), layer.seams.end(), earlier);
  }
  layer.first.assign(before + 1, 0);
  for (const FlowSeam& seam : layer.seams) ++layer.first[seam.from + 1];
  for (int u = 0; u < before; ++u) layer.first[u + 1] += layer.first[u];
  layer.gain = stage.rewards;
  layer.capacity_left = stage.capacities;
  layer.flow_in.resize(stage.rewards.size());
  return layer;
}

// Vertices in this order: agents, both halves of all nodes, exit.
class FlowSolver {
 public:
  explicit FlowSolver(const TeamFlow& flow) : agents_(flow.agents) {
    int before = flow.agents;
    int vertices = flow.agents;
    for (const FlowStage& stage : flow.stages) {
      layers_.push_back(ToLayer(stage, before, vertices));
      before = static_cast<int>(stage.rewards.size());
      vertices += 2 * before;
    }
    exit_ = vertices;
    used_.assign(agents_, 0);
    potential_.assign(vertices + 1, kUnreached);
    layer_of_.assign(vertices + 1, kNone);
    // Vertex numbers: agents, then in and out halves stage by stage.
    for (std::size_t s = 0; s < layers_.size(); ++s) {
      for (std::size_t v = 0; v < layers_[s].gain.size(); ++v) {
        layer_of_[layers_[s].in(v)] = layer_of_[layers_[s].out(v)] =
            static_cast<int>(s);
      }
    }
    StartPotentials();
  }

  // Serves one more agent if capacities allow, along the shortest augmenting
  // path.
  bool Augment() {
    Search();
    const double length = cost_[exit_];
    if (!(length < kUnreached)) return false;
    for (std::size_t x = 0; x < potential_.size(); ++x) {
      potential_[x] += std::min(cost_[x], length);
    }
    Push();
    return true;
  }

  // Decomposes the flow into paths, by agent.
  std::vector<std::vector<int>> Paths() const {
    std::vector<std::vector<int>> paths(agents_);
    std::vector<std::vector<int>> at(agents_);  // Agents at each node.
    for (int a = 0; a < agents_; ++a) at[a] = {a};
    for (const FlowLayer& layer : layers_) {
      std::vector<std::vector<int>> next(layer.gain.size());
      for (std::size_t v = 0; v < next.size(); ++v) {
        for (const int seam : layer.flow_in[v]) {
          std::vector<int>& waiting = at[layer.seams[seam].from];
          const int agent = waiting.back();
          waiting.pop_back();
          paths[agent].push_back(static_cast<int>(v));
          next[v].push_back(agent);
        }
      }
      at = std::move(next);
    }
    return paths;
  }

  double Value() const {
    double value = 0.0;
    for (const FlowLayer& layer : layers_) {
      for (std::size_t v = 0; v < layer.gain.size(); ++v) {
        for (const int seam : layer.flow_in[v]) {
          value += layer.gain[v] - layer.seams[seam].cost;
        }
      }
    }
    return value;
  }

 private:
  using Reached = std::pair<double, int>;

  int OutVertex(int layer, int u) const {
    return layer < 0 ? u : layers_[layer].out(u);
  }

  // Initial potentials: shortest distances without flow, stage by stage.
  void StartPotentials() {
    for (int a = 0; a < agents_; ++a) potential_[a] = 0.0;
    for (std::size_t s = 0; s < layers_.size(); ++s) {
      const FlowLayer& layer = layers_[s];
      // The trellis is acyclic: one pass gives exact distances although costs
      // are negative where rewards are.
      for (const FlowSeam& seam : layer.seams) {
        double& in = potential_[layer.in(seam.to)];
        in = std::min(
            in, potential_[OutVertex(static_cast<int>(s) - 1, seam.from)] +
                    seam.cost);
      }
      for (std::size_t v = 0; v < layer.gain.size(); ++v) {
        if (layer.capacity_left[v] > 0) {
          potential_[layer.out(v)] = potential_[layer.in(v)] - layer.gain[v];
        }
      }
    }
    const FlowLayer& last = layers_.back();
    for (std::size_t v = 0; v < last.gain.size(); ++v) {
      potential_[exit_] = std::min(potential_[exit_], potential_[last.out(v)]);
    }
  }

  // Relaxation step; vertices not nearer than the exit are irrelevant.
  void Reach(int from, int to, double cost, int parent) {
    const double reached =
        cost_[from] + std::max(0.0, cost + potential_[from] - potential_[to]);
    if (!(reached < cost_[to] && reached < cost_[exit_])) return;
    cost_[to] = reached;
    parent_[to] = parent;
    queue_.push({reached, to});
  }

  void LeaveOut(int vertex, int layer, int u) {
    if (layer >= 0 && !layers_[layer].flow_in[u].empty()) {
      Reach(vertex, layers_[layer].in(u), layers_[layer].gain[u], kThroughNode);
    }
    if (layer + 1 == static_cast<int>(layers_.size())) {
      Reach(vertex, exit_, 0.0, u);
      return;
    }
    const FlowLayer& next = layers_[layer + 1];
    for (int e = next.first[u]; e < next.first[u + 1]; ++e) {
      Reach(vertex, next.in(next.seams[e].to), next.seams[e].cost, e);
    }
  }

  void LeaveIn(int vertex, int layer, int v) {
    const FlowLayer& here = layers_[layer];
    if (here.capacity_left[v] > 0) {
      Reach(vertex, here.out(v), -here.gain[v], kThroughNode);
    }
    for (const int e : here.flow_in[v]) {
      Reach(vertex, OutVertex(layer - 1, here.seams[e].from),
            -here.seams[e].cost, e);
    }
  }

  // Dijkstra's algorithm from the unserved agents to the exit.
  void Search() {
    cost_.assign(potential_.size(), kUnreached);
    parent_.assign(potential_.size(), kNone);
    queue_ = {};
    for (int a = 0; a < agents_; ++a) {
      if (used_[a]) continue;
      cost_[a] = 0.0;
      queue_.push({0.0, a});
    }
    while (!queue_.empty()) {
      const auto [cost, vertex] = queue_.top();
      queue_.pop();
      // Vertices beyond the exit are not needed: potentials are capped there.
      if (vertex == exit_) return;
      // Outdated queue entry.
      if (cost > cost_[vertex]) continue;
      const int layer = layer_of_[vertex];
      const int nodes = layer < 0 ? 0 : layers_[layer].nodes();
      const int at = layer < 0 ? vertex : vertex - layers_[layer].first_node;
      if (at >= nodes) {
        LeaveOut(vertex, layer, at - nodes);
      } else {
        LeaveIn(vertex, layer, at);
      }
    }
  }

  // Pushes one unit along the parents, from the exit back to an agent.
  void Push() {
    int layer = static_cast<int>(layers_.size()) - 1;
    int node = parent_[exit_];
    while (true) {
      const int out_parent = parent_[OutVertex(layer, node)];
      if (out_parent == kNone) break;  // Reached an unserved agent.
      if (out_parent == kThroughNode) {
        --layers_[layer].capacity_left[node];
      } else {
        ++layer;
        node = layers_[layer].seams[out_parent].to;
        std::vector<int>& flow = layers_[layer].flow_in[node];
        flow.erase(std::find(flow.begin(), flow.end(), out_parent));
      }
      // At the in half of a node.
      const int in_parent = parent_[layers_[layer].in(node)];
      if (in_parent == kThroughNode) {
        ++layers_[layer].capacity_left[node];
      } else {
        layers_[layer].flow_in[node].push_back(in_parent);
        node = layers_[layer].seams[in_parent].from;
        --layer;
      }
    }
    used_[node] = 1;
  }

  std::vector<FlowLayer> layers_;
  int agents_ = 0;
  int exit_ = 0;
  std::vector<char> used_;         // True for served agents.
  std::vector<int> layer_of_;      // Stage of each vertex; kNone for agents.
  std::vector<double> potential_;  // Potential of each vertex.

  // State of the current search, by vertex: reduced cost and parent (a seam or
  // kThroughNode). The exit's parent is a node.
  std::vector<double> cost_;
  std::vector<int> parent_;
  std::priority_queue<Reached, std::vector<Reached>, std::greater<Reached>>
      queue_;
};

}  // namespace

FlowPlan SolveFlow(const TeamFlow& flow) {
  for (std::size_t s = 0; s < flow.stages.size(); ++s) CheckStage(flow, s);
  FlowPlan plan;
  plan.nodes.resize(flow.agents);
  if (flow.stages.empty()) return plan;
  FlowSolver solver(flow);
  while (solver.Augment()) {
  }
  plan.nodes = solver.Paths();
  plan.value = solver.Value();
  return plan;
}

}  // namespace kg_selector
