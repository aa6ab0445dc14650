// Synthetic teams of any size: agents on one trellis whose nodes have a
// capacity. For benchmarks and tests of whole teams; a mission that has only
// places.
//
// Seam costs: one table per stage, times the agent's weight. Rewards: the
// agent's own blend of three layers.

#ifndef KG_SELECTOR_TESTING_TRELLIS_TEAM_H_
#define KG_SELECTOR_TESTING_TRELLIS_TEAM_H_

#include <algorithm>
#include <cstddef>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include "kg_selector/team/team_search.h"

namespace kg_selector {

struct TrellisTeamOptions {
  int agents = 3;
  int nodes = 20;  // Nodes per stage.
  int stages = 7;
  int capacity = 1;
  bool homogeneous = false;  // Agents differ only in their start.
};

class TrellisTeam {
 public:
  TrellisTeam(const TrellisTeamOptions& options, unsigned seed)
      : options_(options) {
    std::mt19937 prng(seed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const std::size_t n = options.nodes;
    const auto table = [&](std::size_t size) {
      std::vector<float> values(size);
      for (float& value : values) value = static_cast<float>(unit(prng));
      return values;
    };
    for (int t = 0; t < options.stages; ++t) {
      seams_.push_back(table(n * n));
      for (auto& layer : layers_) layer.push_back(table(n));
    }
    for (int a = 0; a < options.agents; ++a) {
      starts_.push_back(table(n));
      agents_.push_back(MakeAgent(&prng));
    }
  }

  const TrellisTeamOptions& options() const { return options_; }
  int row(int stage, int node) const { return stage * options_.nodes + node; }

  float Reward(int agent, int stage, int node) const {
    float sum = 0.0F;
    for (int k = 0; k < 3; ++k) {
      sum += agents_[agent].blend[k] * layers_[k][stage][node];
    }
    return sum;
  }
  // In the first stage `from` is 0, the start.
  float SeamCost(int agent, int stage, int from, int to) const {
    const float base = stage == 0 ? starts_[agent][to]
                                  : seams_[stage][from * options_.nodes + to];
    return agents_[agent].weight * base;
  }

  TeamColumns MakePool() const {
    TeamColumns pool(options_.agents);
    for (int r = 0; r < options_.stages * options_.nodes; ++r) {
      pool.AddRow(options_.capacity);
    }
    return pool;
  }

  // The agent's best path; its column is added to the pool.
  ColumnAnswer Answer(int agent, const ColumnRequest& request,
                      TeamColumns* pool) const {
    const int n = options_.nodes;
    std::vector<float> value = NodeValues(agent, request, *pool);
    std::vector<int> before(value.size(), 0);
    for (int v = 0; v < n; ++v) value[v] -= SeamCost(agent, 0, 0, v);
    const float weight = agents_[agent].weight;
    std::vector<float> best(n);
    for (int t = 1; t < options_.stages; ++t) {
      // The inner loop runs over targets so that the compiler vectorises it.
      const float* from = &value[row(t - 1, 0)];
      std::fill(best.begin(), best.end(), -kNever);
      int* came = &before[row(t, 0)];
      for (int u = 0; u < n; ++u) {
        const float* seams = &seams_[t][static_cast<std::size_t>(u) * n];
        const float at = from[u];
        for (int v = 0; v < n; ++v) {
          const float sum = at - weight * seams[v];
          came[v] = sum > best[v] ? u : came[v];
          best[v] = sum > best[v] ? sum : best[v];
        }
      }
      for (int v = 0; v < n; ++v) value[row(t, v)] += best[v];
    }
    return Trace(agent, value, before, pool);
  }

 private:
  static constexpr float kNever = 1e9F;

  struct Agent {
    float blend[3] = {1.0F, 0.0F, 0.0F};
    float weight = 1.0F;
  };

  Agent MakeAgent(std::mt19937* prng) const {
    Agent agent;
    if (options_.homogeneous) return agent;
    std::uniform_real_distribution<float> unit(0.0F, 1.0F);
    float sum = 0.0F;
    for (float& share : agent.blend) sum += share = unit(*prng);
    for (float& share : agent.blend) share /= sum;
    agent.weight = 0.5F + unit(*prng);
    return agent;
  }

  std::vector<float> NodeValues(int agent, const ColumnRequest& request,
                                const TeamColumns& pool) const {
    const std::size_t rows = pool.capacities().size();
    // Full nodes get a prohibitive price.
    std::vector<int> used(rows, 0);
    for (const int column : request.around) {
      for (const int r : pool.columns()[column].rows) ++used[r];
    }
    std::vector<float> value(rows);
    for (int t = 0; t < options_.stages; ++t) {
      for (int v = 0; v < options_.nodes; ++v) {
        const int r = row(t, v);
        value[r] = Reward(agent, t, v);
        if (r < static_cast<int>(request.prices.size())) {
          value[r] -= static_cast<float>(request.prices[r]);
        }
        if (used[r] >= pool.capacities()[r]) value[r] = -kNever;
      }
    }
    return value;
  }

  ColumnAnswer Trace(int agent, const std::vector<float>& value,
                     const std::vector<int>& before, TeamColumns* pool) const {
    const int last = options_.stages - 1;
    const auto ends = value.begin() + row(last, 0);
    int node =
        static_cast<int>(std::max_element(ends, ends + options_.nodes) - ends);
    ColumnAnswer answer;
    answer.bound = static_cast<double>(ends[node]);
    // Every path passes a full node: no answer.
    if (ends[node] < -0.5F * kNever) return {{}, 0.0};
    Column column;
    column.agent = agent;
    for (int t = last; t >= 0; --t) {
      column.rows.push_back(row(t, node));
      const int from = before[row(t, node)];
      column.score += static_cast<double>(Reward(agent, t, node)) -
                      static_cast<double>(SeamCost(agent, t, from, node));
      node = from;
    }
    std::reverse(column.rows.begin(), column.rows.end());
    answer.columns = {pool->AddIfNew(std::move(column))};
    return answer;
  }

  TrellisTeamOptions options_;
  std::vector<std::vector<float>> seams_;      // By stage; index (from, to).
  std::vector<std::vector<float>> layers_[3];  // By stage; index node.
  std::vector<std::vector<float>> starts_;     // By agent and node.
  std::vector<Agent> agents_;
};

// Runs a search until it returns no requests.
inline void RunSearch(const TrellisTeam& team, TeamSearch* search,
                      TeamColumns* pool) {
  ColumnRequests requests;
  for (int a = 0; a < team.options().agents; ++a) requests[a] = {};
  while (!requests.empty()) {
    ColumnAnswers answers;
    for (const auto& [agent, request] : requests) {
      answers[agent] = team.Answer(agent, request, pool);
    }
    requests = search->Next(*pool, answers);
  }
}

}  // namespace kg_selector

#endif  // KG_SELECTOR_TESTING_TRELLIS_TEAM_H_
