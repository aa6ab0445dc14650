// Messages carry what the libraries mean, both ways, and refuse nonsense.

#include <cmath>
#include <limits>
#include <random>

#include "gtest/gtest.h"
#include "kg_core/base/input_error.h"
#include "kg_ros/conversion/message_units.h"
#include "kg_ros/conversion/plan_conversion.h"
#include "kg_ros/conversion/rules_conversion.h"
#include "kg_ros/conversion/tensor_conversion.h"

namespace kg_ros {
namespace {

using kg_core::InputError;

kg_core::Grid SmallGrid() {
  return kg_core::Grid({-98.0, -97.96, -97.9}, {18.0, 18.04});
}

void ExpectSameGrid(const kg_core::Grid& a, const kg_core::Grid& b) {
  ASSERT_EQ(a.rows(), b.rows());
  ASSERT_EQ(a.cols(), b.cols());
  for (int i = 0; i < a.cols(); ++i) {
    EXPECT_NEAR(a.lon_deg()[i], b.lon_deg()[i], 1e-12);
  }
  for (int i = 0; i < a.rows(); ++i) {
    EXPECT_NEAR(a.lat_deg()[i], b.lat_deg()[i], 1e-12);
  }
}

kg_compiler::SeamRules RandomRules(std::mt19937* random) {
  std::uniform_real_distribution<double> number(0.1, 5.0);
  kg_compiler::SeamRules rules;
  rules.agent_iri = "http://example.org/mission/alpha";
  rules.agent_id = "alpha";
  rules.world_version = 7;
  rules.motion = {number(*random), 6.0, number(*random), number(*random),
                  number(*random)};
  rules.weights = {number(*random), number(*random), number(*random),
                   number(*random), number(*random)};
  rules.hazard_range_m = number(*random);
  rules.movement_mode = static_cast<kg_compiler::MovementMode>((*random)() % 2);
  rules.energy_budget_j = number(*random);
  rules.sensor_radius_m = number(*random);
  rules.spacing_m = number(*random);
  rules.start = {-90.0 + number(*random), 25.0};
  kg_compiler::WindowRules window;
  window.window = 3;
  window.begin_s = 1.8e9;
  window.end_s = 1.8e9 + 86400.0;
  window.confidence = 0.5;
  window.base_travel_m = number(*random);
  window.events = {{"e", {-89.0, 24.0}, number(*random), number(*random)}};
  window.tensor_hash = "t";
  window.field_hash = "f";
  rules.windows = {window};
  return rules;
}

TEST(ConversionTest, GridsComeBackAsTheyWere) {
  ExpectSameGrid(FromMessage(ToMessage(SmallGrid())), SmallGrid());
}

TEST(ConversionTest, RefusesAxesThatDoNotAscendOrAreNoAngles) {
  kg_msgs::Grid message = ToMessage(SmallGrid());
  message.lon_rad[1] = message.lon_rad[0];
  EXPECT_THROW(FromMessage(message), InputError);
  message = ToMessage(SmallGrid());
  message.lat_rad[0] = std::nan("");
  EXPECT_THROW(FromMessage(message), InputError);
  message.lat_rad.clear();
  EXPECT_THROW(FromMessage(message), InputError);
}

TEST(ConversionTest, RefusesATensorWhoseSizeLies) {
  kg_msgs::MissionTensor message;
  message.grid = ToMessage(SmallGrid());
  message.layers.resize(1);
  message.layers[0].name = "FUSED";
  message.layers[0].values.assign(5, 0.0F);  // Six cells.
  EXPECT_THROW(FromMessage(message), InputError);
  message.layers[0].values.assign(6, 0.0F);
  EXPECT_NO_THROW(FromMessage(message));
  message.layers[0].name = "FUSSED";
  EXPECT_THROW(FromMessage(message), InputError);
}

TEST(ConversionTest, WorkFieldsComeBackAsTheyWere) {
  kg_compiler::WorkField field;
  field.iri = "w";
  field.window = 2;
  field.hash = "h";
  field.field.grid = SmallGrid();
  field.field.slices = {
      {1.8e9, kg_core::Raster(6, 0.5F), kg_core::Raster(6, -0.25F)},
      {1.8e9 + 3600.0, kg_core::Raster(6, 1.0F), kg_core::Raster(6, 0.0F)}};
  const kg_compiler::WorkField back = FromMessage(ToMessage(field, 4));
  EXPECT_EQ(back.hash, "h");
  ASSERT_EQ(back.field.slices.size(), 2u);
  EXPECT_EQ(back.field.slices[1].time_s, 1.8e9 + 3600.0);
  EXPECT_EQ(back.field.slices[0].north_mps, field.field.slices[0].north_mps);
}

TEST(ConversionTest, SeamRulesComeBackAsTheyWere) {
  std::mt19937 random(42);
  for (int i = 0; i < 100; ++i) {
    const kg_compiler::SeamRules rules = RandomRules(&random);
    const kg_msgs::SeamRules message = ToMessage(rules, 12);
    EXPECT_EQ(message.cycle, 12u);
    const kg_compiler::SeamRules back = FromMessage(message);
    EXPECT_EQ(back.motion.cruise_mps, rules.motion.cruise_mps);
    EXPECT_EQ(back.motion.hotel_load_w, rules.motion.hotel_load_w);
    EXPECT_EQ(back.weights.risk_per_s, rules.weights.risk_per_s);
    EXPECT_EQ(back.weights.isolation, rules.weights.isolation);
    EXPECT_EQ(back.hazard_range_m, rules.hazard_range_m);
    EXPECT_EQ(back.movement_mode, rules.movement_mode);
    EXPECT_EQ(back.energy_budget_j, rules.energy_budget_j);
    EXPECT_NEAR(back.start.lon_deg, rules.start.lon_deg, 1e-12);
    ASSERT_EQ(back.windows.size(), 1u);
    EXPECT_EQ(back.windows[0].end_s, rules.windows[0].end_s);
    EXPECT_EQ(back.windows[0].events[0].reward,
              rules.windows[0].events[0].reward);
  }
}

TEST(ConversionTest, RefusesRulesThatAreNoNumbers) {
  std::mt19937 random(1);
  kg_msgs::SeamRules message = ToMessage(RandomRules(&random), 1);
  message.cruise_mps = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(FromMessage(message), InputError);
  message = ToMessage(RandomRules(&random), 1);
  message.windows[0].end = message.windows[0].begin;
  EXPECT_THROW(FromMessage(message), InputError);
  message = ToMessage(RandomRules(&random), 1);
  message.isolation_weight = -0.1;
  EXPECT_THROW(FromMessage(message), InputError);
  message = ToMessage(RandomRules(&random), 1);
  message.movement_mode = "leaps";
  EXPECT_THROW(FromMessage(message), InputError);
}

TEST(ConversionTest, RefusesATeamModeThatDoesNotExist) {
  kg_msgs::CoordinationRules message;
  message.mode = "greedy";
  EXPECT_NO_THROW(FromMessage(message));
  message.mode = "auction";
  EXPECT_THROW(FromMessage(message), InputError);
}

TEST(ConversionTest, RefusesATrackThatGoesBackInTime) {
  std::vector<kg_msgs::TimedPoint> track(2);
  track[0].stamp = ros::Time(20.0);
  track[1].stamp = ros::Time(10.0);
  EXPECT_THROW(FromMessage(track), InputError);
}

kg_compiler::NavGraph SmallGraph() {
  kg_compiler::NavGraph graph;
  graph.agent_iri = "http://example.org/mission/alpha";
  graph.window = 3;
  graph.hash = "0af1";
  graph.waypoints = {{0, {-90.0, 25.0}, 2.5, 0.5, {"e"}, 1.5, {3, 4, 9}},
                     {1, {-89.0, 24.0}, 1.25, 0.25, {}, 0.0, {}}};
  kg_compiler::TraverseEdge edge;
  edge.from = 4;
  edge.to = 1;
  edge.flight.track = {{{-90.0, 25.0}, 1.8e9}, {{-89.0, 24.0}, 1.8e9 + 9.0}};
  edge.flight.travel_s = 9.0;
  edge.flight.energy_j = 7.5;
  edge.flight.hazard_s = 0.125;
  edge.flight.through_water_m = 6.0;
  edge.flight.speed_mps = 0.6875;
  edge.seam_cost = 0.375;
  edge.isolation_s = 0.0625;
  graph.edges = {edge};
  edge.via = {1, 0};
  graph.edges.push_back(edge);
  edge.via.clear();
  edge.from = 0;
  graph.inner_edges = {edge};
  graph.movement_mode = kg_compiler::MovementMode::kEdges;
  return graph;
}

TEST(ConversionTest, AWaypointGraphComesBackAsItWas) {
  const kg_compiler::NavGraph graph = SmallGraph();
  const kg_compiler::NavGraph back = FromMessage(ToMessage(graph, {}));
  EXPECT_EQ(graph.agent_iri, back.agent_iri);
  EXPECT_EQ(graph.window, back.window);
  EXPECT_EQ(graph.hash, back.hash);
  ASSERT_EQ(2u, back.waypoints.size());
  for (std::size_t i = 0; i < 2; ++i) {
    const auto& a = graph.waypoints[i];
    const auto& b = back.waypoints[i];
    EXPECT_EQ(a.id, b.id);
    EXPECT_NEAR(a.position.lon_deg, b.position.lon_deg, 1e-12);
    EXPECT_EQ(a.score, b.score);
    EXPECT_EQ(a.value, b.value);
    EXPECT_EQ(a.events, b.events);
    EXPECT_EQ(a.event_reward, b.event_reward);
    EXPECT_EQ(a.footprint, b.footprint);
  }
  ASSERT_EQ(2u, back.edges.size());
  EXPECT_TRUE(back.edges[0].via.empty());
  EXPECT_EQ(graph.edges[1].via, back.edges[1].via);
  const auto& a = graph.edges[0];
  const auto& b = back.edges[0];
  EXPECT_EQ(a.from, b.from);
  EXPECT_EQ(a.to, b.to);
  EXPECT_EQ(a.seam_cost, b.seam_cost);
  EXPECT_EQ(a.flight.travel_s, b.flight.travel_s);
  EXPECT_EQ(a.flight.energy_j, b.flight.energy_j);
  EXPECT_EQ(a.flight.hazard_s, b.flight.hazard_s);
  EXPECT_EQ(a.flight.through_water_m, b.flight.through_water_m);
  EXPECT_EQ(a.flight.speed_mps, b.flight.speed_mps);
  EXPECT_EQ(a.isolation_s, b.isolation_s);
  EXPECT_EQ(2u, b.flight.track.size());
  EXPECT_EQ(kg_compiler::MovementMode::kEdges, back.movement_mode);
  ASSERT_EQ(1u, back.inner_edges.size());
  EXPECT_EQ(0, back.inner_edges[0].from);
  EXPECT_EQ(1, back.inner_edges[0].to);
}

TEST(ConversionTest, APathKeepsItsStopsAndTheCostOfTheWalk) {
  kg_compiler::NavGraph graph = SmallGraph();
  for (auto& edge : graph.edges) edge.from = 0;
  graph.edges[1].seam_cost = 0.75;
  kg_selector::Pathlet path;
  path.visits = {{3, 1, {-89.0, 24.0}, 3.75, {"e"}, {}}};
  for (const bool stops : {false, true}) {
    if (stops) path.visits[0].via = {{1, {-89.0, 24.0}}, {0, {-90.0, 25.0}}};
    const kg_msgs::Pathlet message =
        ToMessage(path, kg_compiler::NavGraphs({graph}));
    EXPECT_EQ(message.visits[0].cost.seam_cost, stops ? 0.75 : 0.375);
    const kg_selector::Pathlet back = FromMessage(message, "a");
    EXPECT_EQ(kg_selector::StopsOf(back.visits[0]),
              kg_selector::StopsOf(path.visits[0]));
    EXPECT_EQ(back.visits[0].events, path.visits[0].events);
    for (std::size_t i = 0; i < path.visits[0].via.size(); ++i)
      EXPECT_NEAR(back.visits[0].via[i].position.lon_deg,
                  path.visits[0].via[i].position.lon_deg, 1e-12);
  }
}

TEST(ConversionTest, RefusesAWaypointGraphThatMakesNoSense) {
  const kg_msgs::NavGraph good = ToMessage(SmallGraph(), {});
  kg_msgs::NavGraph message = good;
  message.waypoints[1].id = 7;
  EXPECT_THROW(FromMessage(message), InputError);
  message = good;
  message.edges[0].to = 2;
  EXPECT_THROW(FromMessage(message), InputError);
  message = good;
  message.edges[0].cost.seam_cost = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(FromMessage(message), InputError);
  message = good;
  message.edges[2].from = 2;  // Within the window there are two.
  EXPECT_THROW(FromMessage(message), InputError);
  message = good;
  message.edges[1].via[0] = 2;
  EXPECT_THROW(FromMessage(message), InputError);
  message = good;
  message.movement_mode = "leaps";
  EXPECT_THROW(FromMessage(message), InputError);
}

TEST(ConversionTest, APositionLiesBetweenItsNeighboursInTime) {
  const std::vector<kg_compiler::TimedPoint> track = {{{-90.0, 25.0}, 100.0},
                                                      {{-89.0, 26.0}, 200.0}};
  EXPECT_EQ(PositionAt(track, 50.0), (kg_core::LonLat{-90.0, 25.0}));
  EXPECT_EQ(PositionAt(track, 250.0), (kg_core::LonLat{-89.0, 26.0}));
  EXPECT_NEAR(PositionAt(track, 125.0).lon_deg, -89.75, 1e-12);
  EXPECT_NEAR(PositionAt(track, 125.0).lat_deg, 25.25, 1e-12);
}

}  // namespace
}  // namespace kg_ros
