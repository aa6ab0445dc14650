#include "kg_selector/testing/team_flow.h"

#include <algorithm>
#include <limits>
#include <random>
#include <stdexcept>

#include "gtest/gtest.h"

namespace kg_selector {
namespace {

int Whole(std::mt19937* prng, int low, int high) {
  return std::uniform_int_distribution<int>(low, high)(*prng);
}
double Number(std::mt19937* prng) {
  return std::uniform_real_distribution<double>(0.0, 10.0)(*prng);
}

TeamFlow RandomFlow(std::mt19937* prng) {
  TeamFlow flow;
  flow.agents = Whole(prng, 1, 3);
  int before = flow.agents;
  for (int s = Whole(prng, 1, 3); s > 0; --s) {
    FlowStage stage;
    const int nodes = Whole(prng, 1, 4);
    for (int v = 0; v < nodes; ++v) {
      stage.rewards.push_back(Number(prng));
      stage.capacities.push_back(Whole(prng, 0, 2));
      for (int u = 0; u < before; ++u) {
        if (Whole(prng, 0, 4) > 0) stage.seams.push_back({u, v, Number(prng)});
      }
    }
    before = nodes;
    flow.stages.push_back(stage);
  }
  return flow;
}

// Exhaustive search: first as many agents as possible, then the best value.
class ReferenceFlow {
 public:
  explicit ReferenceFlow(const TeamFlow& flow) : flow_(flow) {
    for (const FlowStage& stage : flow.stages) {
      room_.push_back(stage.capacities);
    }
    Agent(0, 0, 0.0);
  }
  int served() const { return served_; }
  double value() const { return value_; }

 private:
  void Agent(int agent, int served, double value) {
    if (agent == flow_.agents) {
      if (served > served_ || (served == served_ && value > value_)) {
        served_ = served;
        value_ = value;
      }
      return;
    }
    Agent(agent + 1, served, value);
    Walk(agent, 0, agent, served, value);
  }
  void Walk(int agent, std::size_t stage, int at, int served, double value) {
    if (stage == flow_.stages.size()) {
      Agent(agent + 1, served + 1, value);
      return;
    }
    for (const FlowSeam& seam : flow_.stages[stage].seams) {
      if (seam.from != at || room_[stage][seam.to] == 0) continue;
      --room_[stage][seam.to];
      Walk(agent, stage + 1, seam.to, served,
           value + flow_.stages[stage].rewards[seam.to] - seam.cost);
      ++room_[stage][seam.to];
    }
  }

  const TeamFlow& flow_;
  std::vector<std::vector<int>> room_;
  int served_ = 0;
  double value_ = -std::numeric_limits<double>::infinity();
};

TEST(TeamFlowTest, EqualsTheBestOfAllPlans) {
  int unserved = 0;
  for (unsigned seed = 1; seed <= 1000; ++seed) {
    std::mt19937 prng(seed);
    const TeamFlow flow = RandomFlow(&prng);
    const FlowPlan plan = SolveFlow(flow);
    const ReferenceFlow best(flow);
    int served = 0;
    std::vector<std::vector<int>> used;
    for (const FlowStage& stage : flow.stages) {
      used.emplace_back(stage.rewards.size(), 0);
    }
    for (const auto& nodes : plan.nodes) {
      served += !nodes.empty();
      for (std::size_t s = 0; s < nodes.size(); ++s) ++used[s][nodes[s]];
    }
    for (std::size_t s = 0; s < used.size(); ++s) {
      for (std::size_t v = 0; v < used[s].size(); ++v) {
        ASSERT_LE(used[s][v], flow.stages[s].capacities[v]);
      }
    }
    ASSERT_EQ(served, best.served()) << seed;
    ASSERT_NEAR(plan.value, best.value(), 1e-9) << seed;
    unserved += served < flow.agents;
  }
  EXPECT_GT(unserved, 100);
}

// Both want node 0; the agent that would lose more elsewhere gets it, although
// the other was served first.
TEST(TeamFlowTest, RevisesEarlierChoices) {
  TeamFlow flow;
  flow.agents = 2;
  flow.stages = {
      {{10.0, 8.0, 0.0}, {1, 1, 1}, {{0, 0, 0.0}, {0, 1, 0.0}, {1, 0, 1.0}}}};
  const FlowPlan plan = SolveFlow(flow);
  EXPECT_EQ(plan.nodes, (std::vector<std::vector<int>>{{1}, {0}}));
  EXPECT_DOUBLE_EQ(plan.value, 17.0);
}

TEST(TeamFlowTest, AcceptsNoAgentsAndNoStages) {
  EXPECT_TRUE(SolveFlow({}).nodes.empty());
  TeamFlow flow;
  flow.agents = 2;
  EXPECT_EQ(SolveFlow(flow).nodes.size(), 2u);
  flow.stages.resize(1);
  EXPECT_EQ(SolveFlow(flow).value, 0.0);
}

TEST(TeamFlowTest, RefusesIndicesOutOfRange) {
  TeamFlow flow;
  flow.agents = 1;
  flow.stages = {{{1.0}, {1}, {{1, 0, 0.0}}}};
  EXPECT_THROW(SolveFlow(flow), std::invalid_argument);
  flow.stages = {{{1.0}, {1}, {{0, 1, 0.0}}}};
  EXPECT_THROW(SolveFlow(flow), std::invalid_argument);
  flow.stages = {{{1.0}, {}, {{0, 0, 0.0}}}};
  EXPECT_THROW(SolveFlow(flow), std::invalid_argument);
  flow.stages = {
      {{1.0}, {1}, {{0, 0, std::numeric_limits<double>::quiet_NaN()}}}};
  EXPECT_THROW(SolveFlow(flow), std::invalid_argument);
}

}  // namespace
}  // namespace kg_selector
