// Messages carry what the libraries mean, both ways, and refuse nonsense.

#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <string>

#include "gtest/gtest.h"
#include "kg_compiler/as_sent.h"
#include "kg_core/base/input_error.h"
#include "kg_ros/conversion/ask_conversion.h"
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
  rules.motion = {number(*random), 6.0,
                  number(*random), number(*random),
                  number(*random), number(*random)};
  rules.weights = {number(*random), number(*random), number(*random),
                   number(*random), number(*random), {number(*random)}};
  rules.hazard_range_m = number(*random);
  rules.movement_mode = static_cast<kg_compiler::MovementMode>((*random)() % 2);
  rules.energy_budget_j = number(*random);
  rules.sensor_radius_m = number(*random);
  rules.spacing_m = number(*random);
  rules.hazard_budget_s = (*random)() % 2 == 0
                              ? number(*random)
                              : std::numeric_limits<double>::infinity();
  rules.diverse = (*random)() % 2 == 0;
  rules.minimum_difference = 1 + static_cast<int>((*random)() % 9);
  rules.churn_weight = number(*random);
  rules.start = {-90.0 + number(*random), 25.0};
  kg_compiler::WindowRules window;
  window.window = 3;
  window.begin_s = 1.8e9;
  window.end_s = 1.8e9 + 86400.0;
  window.confidence = 0.5;
  window.base_travel_m = number(*random);
  window.events = {{"e", {-89.0, 24.0}, number(*random), number(*random)}};
  if ((*random)() % 2 == 0) window.committed = {-88.0, 23.0 + number(*random)};
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
  field.field.scalars = {{"wave_height",
                          {{1.8e9, kg_core::Raster(6, 2.0F)},
                           {1.8e9 + 1800.0, kg_core::Raster(6, 3.0F)}}}};
  const kg_compiler::WorkField back = FromMessage(ToMessage(field, 4));
  EXPECT_EQ(back.hash, "h");
  ASSERT_EQ(back.field.slices.size(), 2u);
  EXPECT_EQ(back.field.slices[1].time_s, 1.8e9 + 3600.0);
  EXPECT_EQ(back.field.slices[0].north_mps, field.field.slices[0].north_mps);
  ASSERT_EQ(back.field.scalars.size(), 1u);
  EXPECT_EQ(back.field.scalars[0].quantity, "wave_height");
  EXPECT_EQ(back.field.Hash(), field.field.Hash());
  kg_msgs::WorkField message = ToMessage(field, 4);
  message.scalars[1].stamp = message.scalars[0].stamp;
  EXPECT_THROW(FromMessage(message), InputError);
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
    EXPECT_EQ(back.weights.field_per_s, rules.weights.field_per_s);
    EXPECT_EQ(back.motion.rest_mps, rules.motion.rest_mps);
    EXPECT_EQ(back.hazard_range_m, rules.hazard_range_m);
    EXPECT_EQ(back.movement_mode, rules.movement_mode);
    EXPECT_EQ(back.energy_budget_j, rules.energy_budget_j);
    EXPECT_EQ(back.hazard_budget_s, rules.hazard_budget_s);
    EXPECT_EQ(back.diverse, rules.diverse);
    EXPECT_EQ(back.minimum_difference, rules.minimum_difference);
    EXPECT_EQ(back.churn_weight, rules.churn_weight);
    EXPECT_NEAR(back.start.lon_deg, rules.start.lon_deg, 1e-12);
    ASSERT_EQ(back.windows.size(), 1u);
    EXPECT_EQ(back.windows[0].end_s, rules.windows[0].end_s);
    const auto& committed = rules.windows[0].committed;
    ASSERT_EQ(back.windows[0].committed.has_value(), committed.has_value());
    if (committed) {
      EXPECT_EQ(*back.windows[0].committed, kg_compiler::AsSent(*committed));
    }
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

// A change of a good message, and what is said of it.
template <typename Message>
struct Bad {
  void (*change)(Message*);
  const char* said;
};
template <typename Message>
void ExpectRefusal(Message message, const Bad<Message>& bad) {
  EXPECT_NO_THROW(FromMessage(message));
  bad.change(&message);
  try {
    FromMessage(message);
    ADD_FAILURE() << "taken, though " << bad.said;
  } catch (const InputError& error) {
    const std::string said = error.what();
    EXPECT_NE(said.find(bad.said), std::string::npos) << said;
    EXPECT_EQ(said.find('\n'), std::string::npos);
  }
}

TEST(ConversionTest, RefusesPathRulesThatMakeNoSense) {
  using Rules = kg_msgs::SeamRules;
  const Bad<Rules> all[] = {
      {[](Rules* m) { m->hazard_budget_s = -1; }, "hazard_budget_s"},
      {[](Rules* m) { m->hazard_budget_s = INFINITY; }, "hazard_budget_s"},
      {[](Rules* m) { m->path_choice = "any"; },
       "path_choice 'any': expected one of 'best', 'diverse'"},
      {[](Rules* m) { m->minimum_difference = 0; }, "minimum_difference"},
      {[](Rules* m) { m->churn_weight = -0.5; }, "churn_weight"},
      {[](Rules* m) { m->churn_weight = NAN; }, "churn_weight"},
      {[](Rules* m) {
         m->windows[0].is_committed = true;
         m->windows[0].committed_lat_rad = 2.0;
       },
       "WindowRules.committed"}};
  std::mt19937 random(1);
  const Rules good = ToMessage(RandomRules(&random), 1);
  for (const Bad<Rules>& bad : all) ExpectRefusal(good, bad);
}

kg_msgs::CoordinationRules TeamMessage() {
  Coordination team;
  team.world_version = 3;
  team.cycle = 4;
  team.agents = {"alpha", "bravo"};
  team.energy_budget_j = {1e6, 0.25};
  team.rules.facts.mode = "priced";
  team.rules.facts.gap_goal = 0.125;
  team.rules.facts.auction_epsilon = 0.5;
  team.rules.facts.select_limit_s = 7.5;
  team.rules.facts.fairness = "max_min";
  team.rules.facts.fairness_weight = 1.5;
  team.rules.facts.separation_m = 2000.0;
  team.rules.facts.separation_is_hard = false;
  team.rules.facts.separation_weight = 0.75;
  team.rules.facts.max_rounds = 11;
  team.rules.event_capacity = {{"ex:e", 2}, {"ex:over", 1}};
  team.rules.event_windows = {{"ex:e", {1, 4}}, {"ex:over", {}}};
  kg_core::TimeWindow window;
  window.index = 1;
  window.end_s = 1.8e9;
  team.windows = {window};
  return ToMessage(team);
}

TEST(ConversionTest, TheTeamsRulesComeBackAsTheyWere) {
  const kg_selector::TeamRules team = FromMessage(TeamMessage());
  EXPECT_EQ(team.mode, "priced");
  EXPECT_EQ(team.gap_goal, 0.125);
  EXPECT_EQ(team.auction_epsilon, 0.5);
  EXPECT_EQ(team.time_limit_s, 7.5);
  EXPECT_EQ(team.fairness, "max_min");
  EXPECT_EQ(team.fairness_weight, 1.5);
  EXPECT_EQ(team.separation_m, 2000.0);
  EXPECT_FALSE(team.separation_is_hard);
  EXPECT_EQ(team.separation_weight_per_m, 0.75);
  EXPECT_EQ(team.max_rounds, 11);
  EXPECT_EQ(team.energy_budget_j,
            (std::map<std::string, double>{{"alpha", 1e6}, {"bravo", 0.25}}));
  EXPECT_EQ(team.event_capacity,
            (std::map<std::string, int>{{"ex:e", 2}, {"ex:over", 1}}));
  EXPECT_EQ(team.event_windows, (std::map<std::string, std::set<int>>{
                                    {"ex:e", {1, 4}}, {"ex:over", {}}}));
  EXPECT_EQ(team.window_end_s, (std::map<int, double>{{1, 1.8e9}}));
}

TEST(ConversionTest, RefusesTeamRulesThatMakeNoSense) {
  using Rules = kg_msgs::CoordinationRules;
  const Bad<Rules> all[] = {
      {[](Rules* m) { m->mode = "lottery"; },
       "mode 'lottery': expected one of 'greedy', 'auction', 'priced', "
       "'exact'"},
      {[](Rules* m) { m->gap_goal = 1.5; }, "gap_goal"},
      {[](Rules* m) { m->gap_goal = NAN; }, "gap_goal"},
      {[](Rules* m) { m->auction_epsilon = 0.0; }, "auction_epsilon"},
      {[](Rules* m) { m->time_limit_s = -1.0; }, "time_limit_s"},
      {[](Rules* m) { m->fairness = ""; }, "fairness ''"},
      {[](Rules* m) { m->fairness_weight = -1.0; }, "fairness_weight"},
      {[](Rules* m) { m->separation_weight_per_m = NAN; }, "separation_weight"},
      {[](Rules* m) { m->energy_budget_j.pop_back(); }, "for each of agents"},
      {[](Rules* m) { m->energy_budget_j[0] = NAN; }, "energy_budget_j"}};
  for (const Bad<Rules>& bad : all) ExpectRefusal(TeamMessage(), bad);
}

// What planners are asked: whoever is named, under exactly that.
TEST(ConversionTest, AnAskComesBackAsItWas) {
  kg_selector::Pathlet committed;
  committed.agent = "alpha";
  committed.track = {{{-90.0, 25.0}, 1.8e9}, {{-89.0, 24.0}, 1.8e9 + 9.0}};
  kg_selector::Ask ask;
  ask.around = {committed};
  ask.full_events = {"ex:e", "ex:f"};
  ask.waypoint_prices = {{2, 7, 0.1}, {3, 0, 1e-3}};
  ask.event_prices = {{"ex:g", 2.5}};
  kg_selector::TeamRules rules;
  rules.separation_m = 3000.0;
  kg_msgs::Rejections message;
  AddAsk("bravo", ask, rules, &message);
  AddAsk("charlie", {}, rules, &message);
  const auto back = AskOf(message, "bravo");
  ASSERT_TRUE(back);
  EXPECT_EQ(back->separation_m, 3000.0);
  ASSERT_EQ(back->ask.around.size(), 1u);
  EXPECT_EQ(back->ask.around[0].agent, "alpha");
  EXPECT_EQ(back->ask.around[0].track.size(), 2u);
  EXPECT_EQ(back->ask.full_events, ask.full_events);
  ASSERT_EQ(back->ask.waypoint_prices.size(), 2u);
  EXPECT_EQ(back->ask.waypoint_prices[1].window, 3);
  EXPECT_EQ(back->ask.waypoint_prices[0].waypoint, 7);
  EXPECT_EQ(back->ask.waypoint_prices[0].price, 0.1);
  EXPECT_EQ(back->ask.event_prices, ask.event_prices);
  const auto free = AskOf(message, "charlie");
  ASSERT_TRUE(free);  // Asked for nothing but another answer.
  EXPECT_TRUE(free->ask.around.empty());
  EXPECT_TRUE(free->ask.waypoint_prices.empty());
  EXPECT_FALSE(AskOf(message, "alpha"));
}

TEST(ConversionTest, AnEventMayBeFullWithoutATrackInTheWay) {
  kg_selector::Ask ask;
  ask.full_events = {"ex:e"};
  kg_msgs::Rejections message;
  AddAsk("bravo", ask, {}, &message);
  const auto back = AskOf(message, "bravo");
  ASSERT_TRUE(back);
  EXPECT_TRUE(back->ask.around.empty());
  EXPECT_EQ(back->ask.full_events, ask.full_events);
}

TEST(ConversionTest, APriceWithoutAnAgentIsForAllWhoAreAsked) {
  kg_msgs::Rejections message;
  message.asked = {"alpha", "bravo"};
  message.prices.resize(2);
  message.prices[0].event = "ex:e";
  message.prices[0].price = 2.0;
  message.prices[1].agent = "bravo";
  message.prices[1].price = 1.0;
  EXPECT_EQ(AskOf(message, "alpha")->ask.event_prices.at("ex:e"), 2.0);
  EXPECT_TRUE(AskOf(message, "alpha")->ask.waypoint_prices.empty());
  EXPECT_EQ(AskOf(message, "bravo")->ask.waypoint_prices.size(), 1u);
  for (const double bad : {-1.0, static_cast<double>(NAN)}) {
    message.prices[1].price = bad;
    EXPECT_THROW(AskOf(message, "bravo"), InputError);
    EXPECT_NO_THROW(AskOf(message, "alpha"));
  }
}

TEST(ConversionTest, APathComesBackWithItsStops) {
  kg_selector::Pathlet pathlet;
  pathlet.agent = "alpha";
  pathlet.rank = 3;
  pathlet.reward = 4.5;
  pathlet.seam_cost = 0.5;
  pathlet.energy_j = 1234.5;
  pathlet.visits = {{3, 1, {-89.0, 24.0}, 4.5, {"ex:e"}, {{0, {-90.0, 25.0}}}}};
  kg_compiler::NavGraph graph;
  graph.waypoints.resize(2);
  for (const bool by_way_of : {false, true}) {
    kg_compiler::TraverseEdge edge;
    edge.to = 1;
    if (by_way_of) edge.via = {0};
    edge.flight.travel_s = by_way_of ? 20.0 : 10.0;
    graph.edges.push_back(edge);
  }
  const kg_msgs::Pathlet message =
      ToMessage(pathlet, kg_compiler::NavGraphs({graph}));
  EXPECT_EQ(message.visits.at(0).cost.travel_s, 20.0);  // Of the walk.
  const kg_selector::Pathlet back = FromMessage(message, "alpha");
  EXPECT_EQ(back.rank, 3);
  EXPECT_EQ(back.energy_j, 1234.5);
  ASSERT_EQ(back.visits.size(), 1u);
  EXPECT_EQ(back.visits[0].events, pathlet.visits[0].events);
  ASSERT_EQ(back.visits[0].via.size(), 1u);
  EXPECT_EQ(back.visits[0].via[0].waypoint, 0);
  EXPECT_NEAR(back.visits[0].via[0].position.lon_deg, -90.0, 1e-12);
  for (double kg_msgs::Pathlet::*number :
       {&kg_msgs::Pathlet::reward, &kg_msgs::Pathlet::seam_cost,
        &kg_msgs::Pathlet::energy_j}) {
    kg_msgs::Pathlet bad = message;
    bad.*number = NAN;
    EXPECT_THROW(FromMessage(bad, "alpha"), InputError);
  }
  kg_msgs::Pathlet bad = message;
  bad.visits[0].via[0].lat_rad = NAN;
  EXPECT_THROW(FromMessage(bad, "alpha"), InputError);
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
  edge.exposures = {0.5};
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
  EXPECT_EQ(a.exposures, b.exposures);
  EXPECT_EQ(a.via, b.via);
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
