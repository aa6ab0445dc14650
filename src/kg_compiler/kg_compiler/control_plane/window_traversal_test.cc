#include "kg_compiler/control_plane/window_traversal.h"

#include "gtest/gtest.h"
#include "kg_compiler/control_plane/nav_graph.h"
#include "kg_compiler/testing/test_world.h"

namespace kg_compiler {
namespace {

// An open grid with a soft patch and a closed corner.
MissionTensor RandomTensor(std::mt19937& rng, const kg_base::Grid& grid) {
  kg_base::Raster open(grid.size(), 1.f);
  kg_base::Raster attenuation(grid.size(), 1.f);
  for (std::size_t i = 0; i < grid.size() / 8; ++i) open[i] = 0.f;
  for (std::size_t i = 0; i < grid.size(); i += 7) attenuation[i] = 0.5f;
  MissionTensor tensor;
  tensor.grid = grid;
  tensor.hash = "t";
  tensor.content =
      HoldLayers({{Layer::kFused, RandomRaster(rng, grid.size(), 0, 1)},
                  {Layer::kFeasibility, open},
                  {Layer::kAttenuation, attenuation}});
  return tensor;
}

SeamRules TwoWindows() {
  SeamRules rules;
  rules.agent_iri = "ex:a";
  rules.motion = {0.4, 0.8, 1.0, 7.2, 1.0};
  rules.weights = {1e-5, 1e-6, 1e-4, 0.3, 0.2};
  rules.sensor_radius_m = 8e3;
  rules.max_waypoints = 6;
  rules.start = {-91.0, 24.0};
  for (int window = 0; window < 2; ++window) {
    WindowRules rule;
    rule.window = window;
    rule.begin_s = 86400.0 * window;
    rule.end_s = rule.begin_s + 86400.0;
    rule.confidence = 0.9;
    rule.base_travel_m = 3e4;
    rules.windows.push_back(rule);
  }
  return rules;
}

TEST(PriceWaysTest, AsksWhatTheGraphsAsk) {
  std::mt19937 rng(7);
  const kg_base::Grid grid = EvenGrid(-92.0, 23.0, 0.05, 40, 40);
  int edges = 0;
  for (int i = 0; i < 5; ++i) {
    const MissionTensor tensor = RandomTensor(rng, grid);
    const kg_base::VectorField field =
        RandomFlow(rng, grid, 0.3, 21600.0, 172800.0);
    const SeamRules rules = TwoWindows();
    const std::vector<WindowWorld> worlds(2, {&tensor, &field});
    const auto graphs = CompileNavGraphs(rules, worlds, nullptr);
    for (std::size_t w = 0; w < graphs.size(); ++w) {
      std::vector<WaypointRoute> ways;
      for (const TraverseEdge& edge : graphs[w].edges) {
        ways.push_back(
            {w == 0 ? rules.start : graphs[0].waypoints[edge.from].position,
             graphs[w].waypoints[edge.to].position});
      }
      const WindowTraversal sea(rules, rules.windows[w], worlds[w]);
      const auto prices =
          PriceWays(sea, ways, PositionsOf(graphs[w].waypoints));
      ASSERT_EQ(prices.size(), graphs[w].edges.size());
      for (std::size_t e = 0; e < prices.size(); ++e, ++edges) {
        ASSERT_TRUE(prices[e]);
        EXPECT_EQ(prices[e]->seam_cost, graphs[w].edges[e].seam_cost);
        EXPECT_EQ(prices[e]->flight.energy_j,
                  graphs[w].edges[e].flight.energy_j);
      }
    }
  }
  EXPECT_GT(edges, 50);
}

TEST(PriceWaysTest, AWayToAClosedPlaceOrOffTheGridHasNoPrice) {
  std::mt19937 rng(7);
  const kg_base::Grid grid = EvenGrid(-92.0, 23.0, 0.05, 40, 40);
  const MissionTensor tensor = RandomTensor(rng, grid);
  const kg_base::VectorField field = UniformFlow(grid, 0.0, 0.0);
  const SeamRules rules = TwoWindows();
  const WindowTraversal sea(rules, rules.windows[0], {&tensor, &field});
  const auto prices = PriceWays(sea,
                                {{{-91.0, 24.0}, {-91.0, 23.05}},
                                 {{-91.0, 24.0}, {-80.0, 24.0}},
                                 {{-80.0, 24.0}, {-91.0, 24.0}},
                                 {{-91.0, 24.0}, {-91.05, 24.0}}},
                                {});
  EXPECT_FALSE(prices[0]);
  EXPECT_FALSE(prices[1]);
  EXPECT_FALSE(prices[2]);
  EXPECT_TRUE(prices[3]);
}

// Same world and places: the prices of the policy determine the speed.
TEST(WindowSeaTest, TimeBuysSpeedAndEnergySavesIt) {
  std::mt19937 rng(8);
  const kg_base::Grid grid = EvenGrid(-92.0, 23.0, 0.05, 40, 40);
  SeamRules hasty = TwoWindows();
  hasty.weights = {1e-5, 0.0, 0.0, 0.0, 0.0};
  SeamRules thrifty = hasty;
  thrifty.weights = {0.0, 1e-6, 0.0, 0.0, 0.0};
  int flown = 0;
  for (int i = 0; i < 4; ++i) {
    const MissionTensor tensor = RandomTensor(rng, grid);
    const kg_base::VectorField field =
        RandomFlow(rng, grid, 0.3, 21600.0, 172800.0);
    const WindowWorld world{&tensor, &field};
    const WindowTraversal by_time(hasty, hasty.windows[0], world);
    const WindowTraversal by_energy(thrifty, thrifty.windows[0], world);
    const ReachMap fast = by_time.ReachFrom(hasty.start);
    const ReachMap cheap = by_energy.ReachFrom(hasty.start);
    for (int k = 0; k < 10; ++k) {
      const kg_base::LonLat to{Uniform(rng, -91.15, -90.85),
                               Uniform(rng, 23.85, 24.15)};
      const auto a = by_time.Fly(hasty.start, fast, to);
      const auto b = by_energy.Fly(hasty.start, cheap, to);
      if (!a) continue;
      ASSERT_TRUE(b);
      EXPECT_EQ(hasty.motion.cruise_mps, a->speed_mps);
      EXPECT_LE(b->energy_j, a->energy_j);
      EXPECT_LE(a->travel_s, b->travel_s * 1.001);
      flown += b->speed_mps < a->speed_mps && b->energy_j < a->energy_j &&
               b->travel_s > a->travel_s;
    }
  }
  EXPECT_GT(flown, 10);
}

}  // namespace
}  // namespace kg_compiler
