#include "kg_compiler/control_plane/nav_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

#include "kg_base/common/input_error.h"
#include "kg_base/common/units.h"
#include "kg_base/geo/geodesy.h"
#include "kg_compiler/control_plane/edge_cost.h"
#include "kg_compiler/control_plane/seam_cache.h"
#include "kg_compiler/testing/test_world.h"

namespace kg_compiler {
namespace {

using kg_base::LonLat;

// A mission of a few windows on a small grid of random flow.
struct TestSea {
  explicit TestSea(unsigned seed, double flow_mps = 0.4) : rng(seed) {
    const int windows = 3;
    grid = EvenGrid(-91, 24, 0.04, 60, 60);
    mission.agents = {TestAgent("alpha")};
    mission.coordination.waypoints_per_window = 12;
    mission.coordination.waypoint_spacing_m = 9000;
    for (int t = 0; t < windows; ++t) {
      mission.windows.push_back(TestWindow(t, std::exp(-0.12 * t)));
    }
    kg_mission::Agent& agent = mission.agents[0];
    agent.start = {-89.9, 25.1};
    agent.policy.lambda_time_per_s = 1e-5;
    agent.policy.lambda_risk = 0.1;
    agent.policy.lambda_uncertainty = 0.5;
    value = RandomRaster(rng, grid.size(), 0, 1);
    for (int t = 0; t < windows; ++t) {
      kg_base::VectorField field =
          RandomFlow(rng, grid, flow_mps, 10800, 86400);
      for (auto& slice : field.slices) slice.time_s += t * 86400;
      fields.push_back(std::move(field));
    }
  }
  void Compile(SeamCache* cache = nullptr) {
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
    graphs = CompileNavGraphs(rules, worlds, cache);
  }
  std::mt19937 rng;
  kg_base::Grid grid;
  kg_mission::Mission mission;
  kg_base::Raster value;
  std::vector<kg_base::VectorField> fields;
  std::vector<MissionTensor> tensors;
  std::vector<WindowWorld> worlds;
  SeamRules rules;
  NavGraphs graphs;
};

std::string ErrorOf(TestSea* sea) {
  try {
    sea->Compile();
  } catch (const kg_base::InputError& error) {
    return error.what();
  }
  return "";
}

TEST(NavGraph, DoesNotDependOnTheHeadingIfTurnsHaveNoPrice) {
  TestSea north(1), south(1);
  south.mission.agents[0].start_heading_rad = kg_base::kPi;
  north.Compile();
  south.Compile();
  ASSERT_EQ(north.graphs.size(), south.graphs.size());
  for (std::size_t t = 0; t < north.graphs.size(); ++t) {
    EXPECT_EQ(north.graphs[t].hash, south.graphs[t].hash);
    ASSERT_EQ(north.graphs[t].edges.size(), south.graphs[t].edges.size());
    for (std::size_t i = 0; i < north.graphs[t].edges.size(); ++i) {
      EXPECT_EQ(0.0, north.graphs[t].edges[i].turn_rad);
      EXPECT_EQ(CostOfEdge(north.graphs[t].edges[i]),
                CostOfEdge(south.graphs[t].edges[i]));
    }
  }
}

// The graphs with a price of turns, in a heading [deg].
NavGraphs GraphsHeading(TestSea* sea, double heading_deg, double per_rad,
                        SeamCache* cache = nullptr) {
  sea->mission.agents[0].policy.lambda_turn_per_rad = per_rad;
  sea->mission.agents[0].start_heading_rad = kg_base::DegToRad(heading_deg);
  sea->Compile(cache);
  return sea->graphs;
}

// Angle between a heading and the first leg of a flight, by the dot product of
// vectors to the east and north [rad].
double TurnByVectors(const FlownPath& flight, double heading_deg) {
  const LonLat from = flight.track[0].position, to = flight.track[1].position;
  if (flight.travel_s == 0.0) return 0.0;
  const kg_base::DegreesPerMetre scale = kg_base::LocalScale(from.lat_deg);
  const double east = (to.lon_deg - from.lon_deg) / scale.lon_deg;
  const double north = (to.lat_deg - from.lat_deg) / scale.lat_deg;
  const double heading = kg_base::DegToRad(heading_deg);
  return std::acos(
      std::clamp((east * std::sin(heading) + north * std::cos(heading)) /
                     std::hypot(east, north),
                 -1.0, 1.0));
}

TEST(NavGraph, ChargesEdgesFromTheStartForTheTurnFromTheHeading) {
  for (const double heading_deg : {0.0, 90.0, 217.0, 359.0}) {
    for (const char* mode : {"hops", "edges"}) {
      TestSea sea(13);
      sea.mission.coordination.movement_mode = mode;
      const NavGraphs free = GraphsHeading(&sea, heading_deg, 0.0);
      const NavGraphs priced = GraphsHeading(&sea, heading_deg, 0.75);
      double largest_rad = 0.0;
      for (std::size_t t = 0; t < free.size(); ++t) {
        EXPECT_NE(priced[t].hash, free[t].hash);
        ASSERT_EQ(free[t].edges.size(), priced[t].edges.size());
        for (std::size_t e = 0; e < free[t].edges.size(); ++e) {
          const TraverseEdge& edge = priced[t].edges[e];
          const double turn_rad =
              t == 0 ? TurnByVectors(edge.flight, heading_deg) : 0.0;
          EXPECT_NEAR(turn_rad, edge.turn_rad, 1e-7);
          EXPECT_NEAR(free[t].edges[e].seam_cost + 0.75 * turn_rad,
                      edge.seam_cost, 1e-7);
          largest_rad = std::max(largest_rad, edge.turn_rad);
        }
        for (const TraverseEdge& edge : priced[t].inner_edges) {
          EXPECT_EQ(0.0, edge.turn_rad);
        }
      }
      EXPECT_GT(largest_rad, 1.5);
      EXPECT_LE(largest_rad, kg_base::kPi);
    }
  }
}

TEST(NavGraph, IsRebuiltForAnotherHeadingWithoutFlyingAgain) {
  TestSea sea(14);
  SeamCache cache;
  GraphsHeading(&sea, 0.0, 0.75, &cache);
  const NavGraphs turned = GraphsHeading(&sea, 180.0, 0.75, &cache);
  EXPECT_EQ(1, cache.counts.graphs);
  EXPECT_EQ(2, cache.counts.graphs_kept);
  EXPECT_EQ(0, cache.counts.flights);
  const NavGraphs fresh = GraphsHeading(&sea, 180.0, 0.75);
  for (std::size_t t = 0; t < fresh.size(); ++t) {
    EXPECT_EQ(fresh[t].hash, turned[t].hash);
    ASSERT_EQ(fresh[t].edges.size(), turned[t].edges.size());
    for (std::size_t e = 0; e < fresh[t].edges.size(); ++e) {
      EXPECT_EQ(CostOfEdge(fresh[t].edges[e]), CostOfEdge(turned[t].edges[e]));
    }
  }
}

// The only edge of the first window to an event at a distance [deg] from the
// start, in still water, with a price of 1 per radian of turn.
TraverseEdge EdgeToEvent(double east_deg, double north_deg,
                         double heading_deg) {
  TestSea sea(15, 0.0);
  const LonLat start = sea.mission.agents[0].start;
  sea.mission.coordination.waypoints_per_window = 1;
  kg_mission::Event event;
  event.iri = "ex:event";
  event.position = {start.lon_deg + east_deg, start.lat_deg + north_deg};
  event.value = 1.0;
  event.radius_m = 10.0;
  event.windows = {0};
  sea.mission.events = {event};
  return GraphsHeading(&sea, heading_deg, 1.0)[0].edges.at(0);
}

TEST(NavGraph, MeasuresTurnsFromTheHeadingEitherWay) {
  const double near_rad = 1e-3;
  EXPECT_NEAR(EdgeToEvent(0.3, 0, 0).turn_rad, kg_base::kPi / 2, near_rad);
  EXPECT_NEAR(EdgeToEvent(-0.3, 0, 0).turn_rad, kg_base::kPi / 2, near_rad);
  EXPECT_NEAR(EdgeToEvent(0.3, 0, 300).turn_rad, kg_base::DegToRad(150),
              near_rad);
  EXPECT_NEAR(EdgeToEvent(0, 0.3, 350).turn_rad, kg_base::DegToRad(10),
              near_rad);
  EXPECT_NEAR(EdgeToEvent(0, -0.3, 0).turn_rad, kg_base::kPi, near_rad);
  EXPECT_NEAR(EdgeToEvent(0, -0.3, 180).turn_rad, 0.0, near_rad);
}

TEST(NavGraph, ChargesNoTurnForStaying) {
  const TraverseEdge stay = EdgeToEvent(0, 0, 45);
  EXPECT_EQ(0.0, stay.flight.travel_s);
  EXPECT_EQ(0.0, stay.turn_rad);
}

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
      const kg_base::Mask open(sea.grid.size(), 1);
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
        EXPECT_DOUBLE_EQ(SeamCost(sea.rules.weights, edge, window.confidence),
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

NavGraph FirstGraphCommittedTo(const TestSea& sea, LonLat place) {
  SeamRules rules = sea.rules;
  rules.windows[0].committed = place;
  return CompileNavGraphs(rules, sea.worlds, nullptr)[0];
}
bool HasPlace(const NavGraph& graph, LonLat place) {
  const auto& all = graph.waypoints;
  return std::any_of(all.begin(), all.end(), [&](const Waypoint& waypoint) {
    return waypoint.position == place;
  });
}

TEST(NavGraph, APickThatThePlanIsCommittedToChangesNothing) {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    TestSea sea(seed);
    sea.Compile();
    const NavGraph& free = sea.graphs[0];
    for (const Waypoint& waypoint : free.waypoints) {
      const NavGraph bound = FirstGraphCommittedTo(sea, waypoint.position);
      EXPECT_NE(free.hash, bound.hash);
      ASSERT_EQ(free.waypoints.size(), bound.waypoints.size());
      for (std::size_t i = 0; i < free.waypoints.size(); ++i) {
        EXPECT_EQ(free.waypoints[i].position, bound.waypoints[i].position);
        EXPECT_EQ(free.waypoints[i].score, bound.waypoints[i].score);
        EXPECT_EQ(free.waypoints[i].footprint, bound.waypoints[i].footprint);
      }
      ASSERT_EQ(free.edges.size(), bound.edges.size());
      for (std::size_t i = 0; i < free.edges.size(); ++i) {
        EXPECT_EQ(free.edges[i].to, bound.edges[i].to);
        EXPECT_EQ(free.edges[i].seam_cost, bound.edges[i].seam_cost);
      }
    }
  }
}

TEST(NavGraph, KeepsThePlaceThePlanIsCommittedToWhileItCanBeReached) {
  TestSea sea(2);
  sea.mission.coordination.waypoints_per_window = 3;
  sea.Compile();
  const LonLat beside = {sea.graphs[0].waypoints[1].position.lon_deg + 0.013,
                         sea.graphs[0].waypoints[1].position.lat_deg + 0.007};
  EXPECT_FALSE(HasPlace(sea.graphs[0], beside));
  const NavGraph bound = FirstGraphCommittedTo(sea, beside);
  EXPECT_TRUE(HasPlace(bound, beside));
  EXPECT_EQ(bound.waypoints.size(), 3u);
  for (const LonLat gone : {LonLat{-88.8, 26.2}, LonLat{0.0, 0.0}}) {
    const NavGraph other = FirstGraphCommittedTo(sea, gone);
    EXPECT_FALSE(HasPlace(other, gone));
    EXPECT_EQ(other.waypoints.size(), sea.graphs[0].waypoints.size());
  }
}

TEST(NavGraph, OffersOnlyStayingWhereNothingHasValue) {
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
  SeamCache cache;
  sea.Compile(&cache);
  const NavGraphs first = sea.graphs;
  EXPECT_EQ(3, cache.counts.graphs);
  sea.Compile(&cache);
  EXPECT_EQ(3, cache.counts.graphs_kept);
  for (int t = 0; t < 3; ++t) EXPECT_EQ(&first[t], &sea.graphs[t]);
  // Only the tensor of the last window changes.
  sea.mission.windows[2].confidence = 0.5;
  sea.Compile(&cache);
  EXPECT_EQ(&first[0], &sea.graphs[0]);
  EXPECT_EQ(&first[1], &sea.graphs[1]);
  EXPECT_NE(&first[2], &sea.graphs[2]);
}

void ExpectSameEdges(const std::vector<TraverseEdge>& a,
                     const std::vector<TraverseEdge>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t e = 0; e < a.size(); ++e) {
    EXPECT_EQ(a[e].from, b[e].from);
    EXPECT_EQ(a[e].to, b[e].to);
    EXPECT_EQ(a[e].seam_cost, b[e].seam_cost);
    EXPECT_EQ(a[e].isolation_s, b[e].isolation_s);
    EXPECT_EQ(a[e].flight.travel_s, b[e].flight.travel_s);
    EXPECT_EQ(a[e].flight.energy_j, b[e].flight.energy_j);
    EXPECT_EQ(a[e].flight.hazard_s, b[e].flight.hazard_s);
    EXPECT_EQ(a[e].flight.through_water_m, b[e].flight.through_water_m);
    ASSERT_EQ(a[e].flight.track.size(), b[e].flight.track.size());
    for (std::size_t i = 0; i < a[e].flight.track.size(); ++i) {
      EXPECT_EQ(a[e].flight.track[i].position, b[e].flight.track[i].position);
      EXPECT_EQ(a[e].flight.track[i].time_s, b[e].flight.track[i].time_s);
    }
  }
}

void ExpectSameGraphs(const NavGraphs& a, const NavGraphs& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t t = 0; t < a.size(); ++t) {
    EXPECT_EQ(a[t].hash, b[t].hash);
    ASSERT_EQ(a[t].waypoints.size(), b[t].waypoints.size());
    for (std::size_t w = 0; w < a[t].waypoints.size(); ++w) {
      EXPECT_EQ(a[t].waypoints[w].position, b[t].waypoints[w].position);
      EXPECT_EQ(a[t].waypoints[w].score, b[t].waypoints[w].score);
      EXPECT_EQ(a[t].waypoints[w].value, b[t].waypoints[w].value);
      EXPECT_EQ(a[t].waypoints[w].events, b[t].waypoints[w].events);
      EXPECT_EQ(a[t].waypoints[w].footprint, b[t].waypoints[w].footprint);
    }
    ExpectSameEdges(a[t].edges, b[t].edges);
    ExpectSameEdges(a[t].inner_edges, b[t].inner_edges);
  }
}

TEST(NavGraph, IsTheSameWithAndWithoutAPreviousGraph) {
  TestSea sea(9);
  SeamCache cache;
  sea.Compile(&cache);
  sea.mission.agents[0].policy.lambda_risk = 0.3;
  sea.Compile(&cache);
  const NavGraphs incremental = sea.graphs;
  sea.Compile();
  ExpectSameGraphs(sea.graphs, incremental);
}

// Areas appear, move and disappear; the cache is never cleared.
TEST(NavGraph, IsTheSameFromACacheAfterAnyAreas) {
  int reaches_kept = 0, reaches = 0, flights_kept = 0, flights = 0;
  for (unsigned seed = 20; seed < 23; ++seed) {
    TestSea sea(seed, 0.05);
    sea.mission.agents[0].capabilities.cruise_mps = 0.15;
    sea.mission.agents[0].policy.hazard_range_m = 2000.0;
    sea.mission.coordination.movement_mode = seed % 2 ? "edges" : "hops";
    SeamCache cache;
    for (int step = 0; step < 12; ++step) {
      const double x = Uniform(sea.rng, -90.6, -89.2);
      const double y = Uniform(sea.rng, 24.4, 25.8);
      auto& areas = sea.mission.constraints;
      if (areas.size() > 2) areas.erase(areas.begin());
      areas.push_back(AreaConstraint("ex:c" + std::to_string(step),
                                     step % 3
                                         ? kg_mission::ConstraintKind::kSoft
                                         : kg_mission::ConstraintKind::kNoGo,
                                     Box(x, y, x + 0.15, y + 0.15)));
      areas.back().attenuation = 0.4;
      areas.back().windows = {step % 3, (step + 1) % 3};
      if (ErrorOf(&sea) != "") continue;  // The start is in an area.
      const NavGraphs anew = sea.graphs;
      sea.Compile(&cache);
      ExpectSameGraphs(anew, sea.graphs);
      if (step == 0) continue;
      reaches += cache.counts.reaches;
      reaches_kept += cache.counts.reaches_kept;
      flights += cache.counts.flights;
      flights_kept += cache.counts.flights_kept;
    }
  }
  EXPECT_GT(reaches_kept, reaches / 3);
  EXPECT_GT(flights_kept, flights / 4);
  EXPECT_GT(reaches, 0);
}

TEST(NavGraph, RefusesAStartInAForbiddenPlaceByName) {
  TestSea sea(10);
  sea.mission.constraints = {AreaConstraint(
      "ex:no", kg_mission::ConstraintKind::kNoGo, Box(-90, 25, -89.8, 25.2))};
  EXPECT_NE(std::string::npos, ErrorOf(&sea).find("agent alpha (ex:alpha), "
                                                  "window 0"));
  EXPECT_NE(std::string::npos, ErrorOf(&sea).find("in a no_go area"));
  EXPECT_EQ(std::string::npos, ErrorOf(&sea).find("land"));
  sea.mission.constraints.clear();
  const kg_base::LonLat start = sea.mission.agents[0].start;
  sea.mission.agents[0].start = {-20, 25};
  EXPECT_NE(std::string::npos, ErrorOf(&sea).find("POINT"));
  EXPECT_NE(std::string::npos, ErrorOf(&sea).find("off the grid"));
  sea.mission.agents[0].start = start;
  const std::size_t cell = sea.grid.Index(*sea.grid.CellAt(start));
  for (kg_base::FieldSlice& slice : sea.fields[0].slices) {
    slice.east_mps[cell] = kGap;
  }
  EXPECT_NE(std::string::npos, ErrorOf(&sea).find("on land"));
  EXPECT_EQ(std::string::npos, ErrorOf(&sea).find("no_go"));
}

TEST(NavGraph, RefusesAWindowWithoutReachableEnd) {
  TestSea sea(11);
  sea.mission.agents[0].capabilities.max_mps = 0.0;  // Cannot hold station.
  const std::string error = ErrorOf(&sea);
  EXPECT_NE(std::string::npos, error.find("window 0 (ex:w0)")) << error;
  EXPECT_NE(std::string::npos, error.find("nowhere")) << error;
}

TEST(SeamCost, IsTheWeightedSumOfItsFourTerms) {
  TraverseEdge edge;
  edge.flight.travel_s = 1000;
  edge.flight.energy_j = 2000;
  edge.flight.hazard_s = 250;
  edge.isolation_s = 50;
  EXPECT_DOUBLE_EQ(1.0 + 4.0 + 0.9 + 0.1,
                   SeamCost({1e-3, 2e-3, 3e-3, 0.5, 0.3}, edge, 0.8));
  EXPECT_DOUBLE_EQ(0.0, SeamCost({}, edge, 0.8));
}

TEST(NavGraph, HasEdgesWithinAWindowInTheModeEdgesOnly) {
  int inner = 0, asymmetric = 0;
  for (unsigned seed = 30; seed < 33; ++seed) {
    TestSea sea(seed);
    sea.Compile();
    const NavGraphs hops = sea.graphs;
    sea.mission.coordination.movement_mode = "edges";
    sea.Compile();
    for (std::size_t t = 0; t < sea.graphs.size(); ++t) {
      const NavGraph& graph = sea.graphs[t];
      EXPECT_TRUE(hops[t].inner_edges.empty());
      EXPECT_EQ(MovementMode::kEdges, graph.movement_mode);
      EXPECT_NE(hops[t].hash, graph.hash);
      ExpectSameEdges(hops[t].edges, graph.edges);
      const WindowTraversal window(sea.rules, sea.rules.windows[t],
                                   sea.worlds[t]);
      const auto places = PositionsOf(graph.waypoints);
      std::map<int, int> leaving;
      std::map<std::pair<int, int>, double> times_s;
      for (const TraverseEdge& edge : graph.inner_edges) {
        ++inner;
        EXPECT_NE(edge.from, edge.to);
        EXPECT_LE(++leaving[edge.from], kInnerNeighbours);
        const auto again =
            PriceWays(window, {{places[edge.from], places[edge.to]}}, places);
        ASSERT_TRUE(again[0]);
        EXPECT_EQ(again[0]->seam_cost, edge.seam_cost);
        EXPECT_EQ(sea.rules.windows[t].begin_s,
                  edge.flight.track.front().time_s);
        times_s[{edge.from, edge.to}] = edge.flight.travel_s;
        const auto back = times_s.find({edge.to, edge.from});
        asymmetric +=
            back != times_s.end() && back->second != edge.flight.travel_s;
      }
    }
  }
  EXPECT_GT(inner, 100);
  EXPECT_GT(asymmetric, 20);
}

// Isolation of a place in still water with 40 km of base travel.
double IsolationAmong(const std::vector<LonLat>& waypoints) {
  const kg_base::Grid grid = EvenGrid(-92, 23, 0.05, 40, 40);
  const kg_base::VectorField field = UniformFlow(grid, 0, 0);
  kg_mission::Mission mission;
  mission.windows = {TestWindow(0, 1.0)};
  mission.agents = {TestAgent("alpha")};
  mission.agents[0].policy.isolation_weight = 0.2;
  mission.agents[0].capabilities.base_travel_m = 40e3;
  const SeamRules rules = CompileSeamRules(mission, mission.agents[0], 0);
  const MissionTensor tensor = CompileTensor(
      mission, mission.agents[0], mission.windows[0],
      TestRasters(grid, kg_base::Raster(grid.size(), 1), field.NoData()));
  return WindowTraversal(rules, rules.windows[0], {&tensor, &field})
      .Isolation({-91, 24}, waypoints);
}

TEST(Isolation, FallsWithThePlacesOneCouldGoToInstead) {
  EXPECT_DOUBLE_EQ(0.2, IsolationAmong({}));
  EXPECT_DOUBLE_EQ(0.2, IsolationAmong({{-91, 24}}));     // The place itself.
  EXPECT_DOUBLE_EQ(0.2, IsolationAmong({{-91, 24.19}}));  // 21 km away.
  std::vector<LonLat> near = {{-91, 24}};
  double last = IsolationAmong(near);
  for (int i = 1; i < 8; ++i) {
    near.push_back({-91 + 0.02 * i, 24});
    const double now = IsolationAmong(near);
    EXPECT_LT(now, last);
    EXPECT_DOUBLE_EQ(0.2 / (1 + i), now);
    last = now;
  }
}

TEST(NavGraph, ChargesIsolationByThePolicysWeightAndTheTimeUnderWay) {
  TestSea sea(12);
  sea.mission.agents[0].policy.isolation_weight = 0.0;
  sea.Compile();
  const NavGraphs without = sea.graphs;
  sea.mission.agents[0].policy.isolation_weight = 0.5;
  sea.Compile();
  for (std::size_t t = 0; t < 3; ++t) {
    ASSERT_EQ(without[t].edges.size(), sea.graphs[t].edges.size());
    for (std::size_t e = 0; e < without[t].edges.size(); ++e) {
      const TraverseEdge& edge = sea.graphs[t].edges[e];
      EXPECT_EQ(0.0, without[t].edges[e].isolation_s);
      EXPECT_EQ(edge.flight.travel_s > 0.0, edge.isolation_s > 0.0);
      EXPECT_LE(edge.isolation_s, 0.5 * edge.flight.travel_s);
      EXPECT_DOUBLE_EQ(without[t].edges[e].seam_cost +
                           sea.rules.weights.risk_per_s * edge.isolation_s,
                       edge.seam_cost);
    }
  }
}

// Flights of equal length past a forbidden area at decreasing distance.
TEST(NavGraph, FindsMoreRiskTheNearerAForbiddenArea) {
  const kg_base::Grid grid = EvenGrid(-92, 23, 0.04, 50, 50);
  const kg_base::VectorField field = UniformFlow(grid, 0, 0);
  kg_mission::Mission mission;
  mission.windows = {TestWindow(0, 1.0)};
  mission.agents = {TestAgent("alpha")};
  kg_mission::Policy& policy = mission.agents[0].policy;
  policy.lambda_risk = 1.0;
  policy.lambda_time_per_s = 1e-3;  // Otherwise it would take a detour.
  policy.hazard_range_m = 8e3;
  mission.constraints = {AreaConstraint(
      "ex:no", kg_mission::ConstraintKind::kNoGo, Box(-92, 23, -91.8, 24.9))};
  const SeamRules rules = CompileSeamRules(mission, mission.agents[0], 0);
  const MissionTensor tensor = CompileTensor(
      mission, mission.agents[0], mission.windows[0],
      TestRasters(grid, kg_base::Raster(grid.size(), 1), field.NoData()));
  const WindowTraversal sea(rules, rules.windows[0], {&tensor, &field});
  double last_s = 0.0;
  for (double lon = -91.38; lon > -91.75; lon -= 0.04) {
    const auto price = PriceWays(sea, {{{lon, 23.8}, {lon, 24.1}}}, {});
    ASSERT_TRUE(price[0]) << lon;
    EXPECT_GT(price[0]->flight.hazard_s, last_s) << lon;
    last_s = price[0]->flight.hazard_s;
  }
  // Each policy has its own hazard range.
  SeamRules far = rules;
  far.hazard_range_m = 16e3;
  const WindowTraversal other(far, far.windows[0], {&tensor, &field});
  const WaypointRoute way = {{-91.3, 23.8}, {-91.3, 24.1}};
  EXPECT_GT(PriceWays(other, {way}, {})[0]->flight.hazard_s,
            PriceWays(sea, {way}, {})[0]->flight.hazard_s);
}

TEST(NavGraph, FollowsALoopCurrentOnTheWholeGulf) {
  kg_mission::Mission mission;
  mission.windows = {TestWindow(0, 1.0)};
  mission.agents = {TestAgent("alpha")};
  mission.agents[0].start = {-88.0, 25.5};
  mission.agents[0].capabilities.cruise_mps = 0.3;
  const kg_base::VectorField field = GulfLikeFlow(1, 0, 86400, 43200);
  std::mt19937 rng(1);
  const MissionTensor tensor = CompileTensor(
      mission, mission.agents[0], mission.windows[0],
      TestRasters(field.grid, RandomRaster(rng, field.grid.size(), 0, 1),
                  field.NoData()));
  const auto graphs = CompileNavGraphs(
      CompileSeamRules(mission, mission.agents[0], 0), {{&tensor, &field}}, {});
  EXPECT_GE(graphs[0].waypoints.size(), 3u);
  const kg_base::Mask land = field.NoData();
  for (const TraverseEdge& edge : graphs[0].edges) {
    for (const TimedPoint& p : edge.flight.track) {
      EXPECT_FALSE(land[field.grid.Index(*field.grid.CellAt(p.position))]);
    }
  }
}

}  // namespace
}  // namespace kg_compiler
