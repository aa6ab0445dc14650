#include "kg_compiler/control_plane/nav_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "kg_compiler/test_world.h"
#include "kg_core/base/input_error.h"
#include "kg_core/geo/geodesy.h"

namespace kg_compiler {
namespace {

using kg_core::LonLat;

// A mission of a few windows on a small sea of random flow.
struct TestSea {
  explicit TestSea(unsigned seed, int windows = 3) : rng(seed) {
    grid = EvenGrid(-91, 24, 0.04, 60, 60);
    mission.agents = {TestAgent("alpha")};
    mission.coordination.waypoints_per_window = 12;
    mission.coordination.waypoint_spacing_m = 9000;
    for (int t = 0; t < windows; ++t) {
      mission.windows.push_back(TestWindow(t, std::exp(-0.12 * t)));
    }
    kg_core::Agent& agent = mission.agents[0];
    agent.start = {-89.9, 25.1};
    agent.policy.lambda_time_per_s = 1e-5;
    agent.policy.lambda_risk = 0.1;
    agent.policy.lambda_uncertainty = 0.5;
    value = RandomRaster(rng, grid.size(), 0, 1);
    for (int t = 0; t < windows; ++t) {
      kg_core::VectorField field = RandomFlow(rng, grid, 0.4, 10800, 86400);
      for (auto& slice : field.slices) slice.time_s += t * 86400;
      fields.push_back(std::move(field));
    }
  }
  void Compile(const std::vector<NavGraph>& previous = {}) {
    tensors.clear();
    worlds.clear();
    rules = CompileSeamRules(mission, mission.agents[0], 0);
    for (std::size_t t = 0; t < fields.size(); ++t) {
      tensors.push_back(
          CompileTensor(mission, mission.agents[0], mission.windows[t],
                        TestRasters(grid, value, fields[t].NoData())));
    }
    for (std::size_t t = 0; t < fields.size(); ++t) {
      worlds.push_back({&tensors[t], &fields[t]});
    }
    graphs = CompileNavGraphs(rules, worlds, previous);
  }
  std::mt19937 rng;
  kg_core::Grid grid;
  kg_core::Mission mission;
  kg_core::Raster value;
  std::vector<kg_core::VectorField> fields;
  std::vector<MissionTensor> tensors;
  std::vector<WindowWorld> worlds;
  SeamRules rules;
  std::vector<NavGraph> graphs;
};

TEST(NavGraph, HoldsOnlyWaypointsAndEdgesThatCanBeFlownAgain) {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    TestSea sea(seed);
    sea.Compile();
    std::vector<LonLat> sources = {sea.rules.start};
    for (std::size_t t = 0; t < sea.graphs.size(); ++t) {
      const NavGraph& graph = sea.graphs[t];
      const WindowRules& window = sea.rules.windows[t];
      ASSERT_FALSE(graph.waypoints.empty());
      EXPECT_LE(graph.waypoints.size(), 12u);
      const kg_core::Mask open(sea.grid.size(), 1);
      std::set<int> arrived;
      for (const TraverseEdge& edge : graph.edges) {
        arrived.insert(edge.to);
        std::vector<LonLat> via;
        for (const TimedPoint& p : edge.flight.track) via.push_back(p.position);
        EXPECT_EQ(sources[edge.from], via.front());
        EXPECT_EQ(graph.waypoints[edge.to].position, via.back());
        MotionModel motion = sea.rules.motion;
        motion.cruise_mps = edge.flight.speed_mps;
        const auto again = FlyTrack(
            {{&sea.fields[t], &open, nullptr},
             motion,
             {via.front(), window.begin_s, window.end_s, window.base_travel_m},
             {}},
            via);
        ASSERT_TRUE(again);
        EXPECT_EQ(edge.flight.travel_s, again->travel_s);
        EXPECT_DOUBLE_EQ(
            SeamCost(sea.rules.weights, edge.flight, window.confidence),
            edge.seam_cost);
      }
      EXPECT_EQ(graph.waypoints.size(), arrived.size());
      sources.clear();
      for (const Waypoint& w : graph.waypoints) sources.push_back(w.position);
    }
  }
}

TEST(NavGraph, OrdersWaypointsByScoreAndEdgesByTheirEnds) {
  TestSea sea(5);
  sea.Compile();
  for (const NavGraph& graph : sea.graphs) {
    for (std::size_t i = 0; i < graph.waypoints.size(); ++i) {
      EXPECT_EQ(static_cast<int>(i), graph.waypoints[i].id);
      if (i > 0) {
        EXPECT_GE(graph.waypoints[i - 1].score, graph.waypoints[i].score);
      }
    }
    for (std::size_t i = 1; i < graph.edges.size(); ++i) {
      EXPECT_LT(std::make_pair(graph.edges[i - 1].from, graph.edges[i - 1].to),
                std::make_pair(graph.edges[i].from, graph.edges[i].to));
    }
  }
}

TEST(NavGraph, PutsAReachableEventAmongItsWaypoints) {
  TestSea sea(6);
  sea.mission.events = {{"ex:near", {-89.853, 25.127}, 4.0, 1, 3000.0, {0}},
                        {"ex:far", {-90.9, 24.1}, 9.0, 1, 3000.0, {0}}};
  sea.mission.coordination.waypoints_per_window = 3;
  sea.Compile();
  EXPECT_EQ(3u, sea.graphs[0].waypoints.size());
  int near = 0;
  for (const Waypoint& waypoint : sea.graphs[0].waypoints) {
    EXPECT_EQ(0, std::count(waypoint.events.begin(), waypoint.events.end(),
                            "ex:far"));
    if (waypoint.events.empty()) continue;
    near += waypoint.position == LonLat{-89.853, 25.127};
    EXPECT_DOUBLE_EQ(4.0, waypoint.event_reward);
  }
  EXPECT_EQ(1, near);
  for (const Waypoint& waypoint : sea.graphs[1].waypoints) {
    EXPECT_TRUE(waypoint.events.empty());  // Its window has passed.
  }
}

TEST(NavGraph, StaysPutWhereNothingElseIsWorthGoing) {
  TestSea sea(7);
  sea.mission.agents[0].policy.alpha_base = 0.0;  // Zero everywhere.
  sea.Compile();
  for (const NavGraph& graph : sea.graphs) {
    ASSERT_EQ(1u, graph.waypoints.size());
    EXPECT_EQ(sea.rules.start, graph.waypoints[0].position);
    EXPECT_EQ(0.0, graph.edges[0].flight.travel_s);
  }
}

TEST(NavGraph, ReusesWhatDidNotChangeAndRebuildsWhatDid) {
  TestSea sea(8);
  sea.Compile();
  std::vector<NavGraph> marked = sea.graphs;
  for (NavGraph& graph : marked) graph.waypoints[0].value = 77.0;
  sea.Compile(marked);
  for (const NavGraph& graph : sea.graphs) {
    EXPECT_EQ(77.0, graph.waypoints[0].value);
  }
  // The last window's tensor alone changes.
  sea.mission.windows[2].confidence = 0.5;
  sea.Compile(marked);
  EXPECT_EQ(77.0, sea.graphs[0].waypoints[0].value);
  EXPECT_EQ(77.0, sea.graphs[1].waypoints[0].value);
  EXPECT_NE(77.0, sea.graphs[2].waypoints[0].value);
}

TEST(NavGraph, IsTheSameBuiltAnewAsBuiltOnAnother) {
  TestSea sea(9);
  sea.Compile();
  const std::vector<NavGraph> before = sea.graphs;
  sea.mission.agents[0].policy.lambda_risk = 0.3;
  sea.Compile(before);
  const std::vector<NavGraph> incremental = sea.graphs;
  sea.Compile();
  for (std::size_t t = 0; t < sea.graphs.size(); ++t) {
    EXPECT_EQ(sea.graphs[t].hash, incremental[t].hash);
    ASSERT_EQ(sea.graphs[t].edges.size(), incremental[t].edges.size());
    for (std::size_t e = 0; e < incremental[t].edges.size(); ++e) {
      EXPECT_EQ(sea.graphs[t].edges[e].seam_cost,
                incremental[t].edges[e].seam_cost);
    }
  }
}

std::string ErrorOf(TestSea* sea) {
  try {
    sea->Compile();
  } catch (const kg_core::InputError& error) {
    return error.what();
  }
  return "";
}

TEST(NavGraph, RefusesAStartInAForbiddenPlaceByName) {
  TestSea sea(10);
  sea.mission.constraints = {AreaConstraint(
      "ex:no", kg_core::ConstraintKind::kNoGo, Box(-90, 25, -89.8, 25.2))};
  EXPECT_NE(std::string::npos, ErrorOf(&sea).find("agent alpha (ex:alpha), "
                                                  "window 0"));
  sea.mission.constraints.clear();
  sea.mission.agents[0].start = {-20, 25};
  EXPECT_NE(std::string::npos, ErrorOf(&sea).find("POINT"));
}

TEST(NavGraph, RefusesAWindowAtWhoseEndTheAgentCanBeNowhere) {
  TestSea sea(11);
  sea.mission.agents[0].capabilities.max_mps = 0.0;  // Cannot hold station.
  const std::string error = ErrorOf(&sea);
  EXPECT_NE(std::string::npos, error.find("window 0 (ex:w0)")) << error;
  EXPECT_NE(std::string::npos, error.find("nowhere")) << error;
}

TEST(SeamCost, IsTheWeightedSumOfItsFourTerms) {
  Flight flight;
  flight.travel_s = 1000;
  flight.energy_j = 2000;
  flight.hazard_s = 300;
  EXPECT_DOUBLE_EQ(1.0 + 4.0 + 0.9 + 0.1,
                   SeamCost({1e-3, 2e-3, 3e-3, 0.5}, flight, 0.8));
  EXPECT_DOUBLE_EQ(0.0, SeamCost({}, flight, 0.8));
}

TEST(NavGraph, FollowsALoopCurrentOnTheWholeGulf) {
  kg_core::Mission mission;
  mission.windows = {TestWindow(0, 1.0)};
  mission.agents = {TestAgent("alpha")};
  mission.agents[0].start = {-88.0, 25.5};
  mission.agents[0].capabilities.cruise_mps = 0.3;
  const kg_core::VectorField field = GulfLikeFlow(1, 0, 86400, 43200);
  std::mt19937 rng(1);
  const MissionTensor tensor = CompileTensor(
      mission, mission.agents[0], mission.windows[0],
      TestRasters(field.grid, RandomRaster(rng, field.grid.size(), 0, 1),
                  field.NoData()));
  const auto graphs = CompileNavGraphs(
      CompileSeamRules(mission, mission.agents[0], 0), {{&tensor, &field}}, {});
  EXPECT_GE(graphs[0].waypoints.size(), 3u);
  const kg_core::Mask land = field.NoData();
  for (const TraverseEdge& edge : graphs[0].edges) {
    for (const TimedPoint& p : edge.flight.track) {
      EXPECT_FALSE(land[field.grid.Index(*field.grid.CellAt(p.position))]);
    }
  }
}

}  // namespace
}  // namespace kg_compiler
