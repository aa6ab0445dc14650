// Round trips of values through messages, and rejection of invalid messages.

#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <random>
#include <set>
#include <string>

#include "gtest/gtest.h"
#include "kg_base/common/input_error.h"
#include "kg_compiler/compile/as_sent.h"
#include "kg_engine/simulation/agent_simulator.h"
#include "kg_ros/conversion/agent_conversion.h"
#include "kg_ros/conversion/message_units.h"
#include "kg_ros/conversion/plan_conversion.h"
#include "kg_ros/conversion/rules_conversion.h"
#include "kg_ros/conversion/tensor_conversion.h"

namespace kg_ros {
namespace {

using kg_base::InputError;

kg_base::Grid SmallGrid() {
  return kg_base::Grid({-98.0, -97.96, -97.9}, {18.0, 18.04});
}

void ExpectSameGrid(const kg_base::Grid& a, const kg_base::Grid& b) {
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
                   number(*random), number(*random), {number(*random)},
                   number(*random)};
  rules.start_heading_rad = number(*random);
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
      {1.8e9, kg_base::Raster(6, 0.5F), kg_base::Raster(6, -0.25F)},
      {1.8e9 + 3600.0, kg_base::Raster(6, 1.0F), kg_base::Raster(6, 0.0F)}};
  field.field.scalars = {{"wave_height",
                          {{1.8e9, kg_base::Raster(6, 2.0F)},
                           {1.8e9 + 1800.0, kg_base::Raster(6, 3.0F)}}}};
  const kg_compiler::WorkField back = FromMessage(ToMessage(field, 4));
  EXPECT_EQ(back.hash, "h");
  ASSERT_EQ(back.field.slices.size(), 2u);
  EXPECT_EQ(back.field.slices[1].time_s, 1.8e9 + 3600.0);
  EXPECT_EQ(back.field.slices[0].north_mps, field.field.slices[0].north_mps);
  ASSERT_EQ(back.field.scalars.size(), 1u);
  EXPECT_EQ(back.field.scalars[0].quantity, "wave_height");
  const auto& slices = back.field.scalars[0].slices;
  ASSERT_EQ(slices.size(), 2u);
  EXPECT_EQ(slices[1].time_s, 1.8e9 + 1800.0);
  EXPECT_EQ(slices[1].values, field.field.scalars[0].slices[1].values);
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
    EXPECT_EQ(back.weights.turn_per_rad, rules.weights.turn_per_rad);
    EXPECT_EQ(back.start_heading_rad, rules.start_heading_rad);
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
  message.lambda_turn_per_rad = -0.1;
  EXPECT_THROW(FromMessage(message), InputError);
  message = ToMessage(RandomRules(&random), 1);
  message.movement_mode = "leaps";
  EXPECT_THROW(FromMessage(message), InputError);
}

// A change that invalidates a message, and the expected error.
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
  kg_mission::TimeWindow window;
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

// Requests reach exactly the named agents, with exactly the stated conditions.
TEST(ConversionTest, ARequestComesBackAsItWas) {
  kg_selector::Pathlet committed;
  committed.agent = "alpha";
  committed.track = {{{-90.0, 25.0}, 1.8e9}, {{-89.0, 24.0}, 1.8e9 + 9.0}};
  kg_selector::PlanRequest ask;
  ask.around = {committed};
  ask.full_events = {"ex:e", "ex:f"};
  ask.waypoint_prices = {{2, 7, 0.1}, {3, 0, 1e-3}};
  ask.event_prices = {{"ex:g", 2.5}};
  kg_selector::TeamRules rules;
  rules.separation_m = 3000.0;
  kg_selector::RoundRequest request;
  request.time_s = 1.75e9;
  request.world_version = 5;
  request.cycle = 6;
  request.run = 7;
  request.round = 2;
  kg_selector::AddAsk("bravo", ask, rules, &request);
  kg_selector::AddAsk("charlie", {}, rules, &request);
  const kg_msgs::RoundRequest message = ToMessage(request);
  EXPECT_EQ(message.asked, request.asked);
  const kg_selector::RoundRequest same = FromMessage(message);
  EXPECT_EQ(same.time_s, 1.75e9);
  EXPECT_EQ(same.world_version, 5u);
  EXPECT_EQ(same.cycle, 6u);
  EXPECT_EQ(same.run, 7u);
  EXPECT_EQ(same.round, 2u);
  ASSERT_EQ(same.cooling.size(), 1u);
  EXPECT_EQ(same.cooling[0].by_agent, "alpha");
  EXPECT_EQ(same.cooling[0].expires_s, 1.75e9);
  const auto back = kg_selector::AskOf(same, "bravo");
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
  const auto free = kg_selector::AskOf(same, "charlie");
  ASSERT_TRUE(free);  // Asked again without conditions.
  EXPECT_TRUE(free->ask.around.empty());
  EXPECT_TRUE(free->ask.waypoint_prices.empty());
  EXPECT_FALSE(kg_selector::AskOf(same, "alpha"));
}

TEST(ConversionTest, TheEndOfARunComesBackWithItsRejections) {
  kg_selector::RunEnd end;
  end.time_s = 1.75e9;
  end.world_version = 5;
  end.cycle = 6;
  end.run = 7;
  end.rejections.resize(1);
  end.rejections[0].agent_iri = "ex:bravo";
  kg_selector::RejectedPath& lost = end.rejections[0].rejection;
  lost.pathlet.agent = "bravo";
  lost.pathlet.rank = 2;
  lost.pathlet.reward = 4.5;
  lost.pathlet.seam_cost = 0.5;
  lost.round = 1;
  lost.reason = "too near";
  lost.conflict.kind = kg_selector::ConflictKind::kEnergy;
  lost.conflict.with_agent = "alpha";
  lost.conflict.window = 3;
  lost.conflict.event = "ex:e";
  lost.conflict.margin = -2.0;
  const kg_msgs::Rejections message = ToMessage(end);
  EXPECT_EQ(message.rejections.at(0).kind, "energy");
  const kg_selector::RunEnd back = FromMessage(message);
  EXPECT_EQ(back.time_s, 1.75e9);
  EXPECT_EQ(back.world_version, 5u);
  EXPECT_EQ(back.cycle, 6u);
  EXPECT_EQ(back.run, 7u);
  ASSERT_EQ(back.rejections.size(), 1u);
  EXPECT_EQ(back.rejections[0].agent_iri, "ex:bravo");
  const kg_selector::RejectedPath& same = back.rejections[0].rejection;
  EXPECT_EQ(same.pathlet.agent, "bravo");
  EXPECT_EQ(same.pathlet.rank, 2);
  EXPECT_EQ(same.pathlet.score(), 4.0);
  EXPECT_EQ(same.round, 1);
  EXPECT_EQ(same.reason, "too near");
  EXPECT_EQ(same.conflict.kind, kg_selector::ConflictKind::kEnergy);
  EXPECT_EQ(same.conflict.with_agent, "alpha");
  EXPECT_EQ(same.conflict.window, 3);
  EXPECT_EQ(same.conflict.event, "ex:e");
  EXPECT_EQ(same.conflict.margin, -2.0);
}

TEST(ConversionTest, APlanComesBackAsItWas) {
  kg_selector::CommittedPlan plan;
  plan.time_s = 1.75e9;
  plan.world_version = 3;
  plan.cycle = 4;
  plan.run = 5;
  plan.rounds = 6;
  plan.reward = 7.5;
  plan.seam_cost = 0.25;
  plan.bound = std::numeric_limits<double>::infinity();
  plan.mode = "exact";
  plan.stability = 0.5;
  plan.displacement_m = 100.0;
  plan.assignments.resize(1);
  plan.assignments[0].agent_iri = "ex:alpha";
  plan.assignments[0].pathlet.agent = "alpha";
  plan.unassigned = {{"bravo", "no path: none"}};
  plan.stages = {{"select", 0.5, 2}};
  const kg_msgs::Assignments message = ToMessage(plan);
  EXPECT_TRUE(std::isnan(message.bound));
  EXPECT_EQ(message.unassigned.at(0), "bravo: no path: none");
  const kg_selector::CommittedPlan back = FromMessage(message);
  EXPECT_EQ(back.time_s, plan.time_s);
  EXPECT_EQ(back.world_version, 3u);
  EXPECT_EQ(back.cycle, 4u);
  EXPECT_EQ(back.run, 5u);
  EXPECT_EQ(back.rounds, 6);
  EXPECT_EQ(back.reward, 7.5);
  EXPECT_EQ(back.seam_cost, 0.25);
  EXPECT_EQ(back.mode, "exact");
  EXPECT_EQ(back.stability, 0.5);
  EXPECT_EQ(back.displacement_m, 100.0);
  ASSERT_EQ(back.assignments.size(), 1u);
  EXPECT_EQ(back.assignments[0].agent_iri, "ex:alpha");
  EXPECT_EQ(back.assignments[0].pathlet.agent, "alpha");
  EXPECT_EQ(back.unassigned, plan.unassigned);
  ASSERT_EQ(back.stages.size(), 1u);
  EXPECT_EQ(back.stages[0].stage, "select");
  EXPECT_EQ(back.stages[0].count, 2u);
}

TEST(ConversionTest, CandidatesThatMakeNoSenseAreRefused) {
  kg_msgs::Candidates message;
  message.agent = "alpha";
  message.proven = true;
  message.bound = 9.0;
  EXPECT_EQ(FromMessage(message).found.bound,
            -std::numeric_limits<double>::infinity());  // No path exists.
  message.pathlets.resize(1);
  message.pathlets[0].reward = 5.0;
  EXPECT_EQ(FromMessage(message).found.bound, 9.0);
  EXPECT_EQ(FromMessage(message).found.pathlets.at(0).agent, "alpha");
  message.pathlets[0].reward = NAN;
  EXPECT_THROW(FromMessage(message), InputError);
}

TEST(ConversionTest, SimulatedAgentsGoOnAlongTheLastPlanWhenPlanningFailed) {
  constexpr double kBegin_s = 1000000.0;
  kg_msgs::World world;
  world.mission_time = ToRosTime(kBegin_s);
  world.windows.resize(1);
  world.windows[0].end = ToRosTime(kBegin_s + 86400.0);
  world.agents.resize(1);
  world.agents[0].id = "alpha";
  kg_selector::CommittedPlan plan;
  plan.assignments.resize(1);
  plan.assignments[0].pathlet.agent = "alpha";
  plan.assignments[0].pathlet.track = {{{0.0, 0.0}, kBegin_s},
                                       {{1.0, 0.0}, kBegin_s + 86400.0}};
  kg_engine::AgentSimulator simulator(3600.0);
  simulator.Take(plan);
  for (const auto& [status, moves] : {std::pair{kg_msgs::World::PLAN_NONE, 0u},
                                      {kg_msgs::World::PLAN_OK, 1u},
                                      {kg_msgs::World::PLAN_STALE, 0u},
                                      {kg_msgs::World::PLAN_FAILED, 1u}}) {
    world.plan_status = status;
    simulator.Take(FromMessage(world));
    EXPECT_EQ(simulator.agents(), std::vector<std::string>{"alpha"});
    EXPECT_EQ(simulator.Advance(1.0).size(), moves);
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
  pathlet.visits[0].cost = {20.0,   7.5, 0.125, 0.0625, 6.0,
                            0.6875, {},  2.5,   0.375};
  const kg_msgs::Pathlet message = ToMessage(pathlet);
  EXPECT_EQ(message.visits.at(0).cost.travel_s, 20.0);
  const kg_selector::Pathlet back = FromMessage(message, "alpha");
  EXPECT_EQ(back.rank, 3);
  EXPECT_EQ(back.energy_j, 1234.5);
  ASSERT_EQ(back.visits.size(), 1u);
  EXPECT_EQ(back.visits[0].events, pathlet.visits[0].events);
  EXPECT_TRUE(back.visits[0].cost == pathlet.visits[0].cost);
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

kg_engine::AgentGraph Made(const kg_compiler::NavGraph& graph) {
  kg_engine::AgentGraph made;
  made.made_s = 1.75e9;
  made.world_version = 8;
  made.cycle = 9;
  made.agent = "alpha";
  made.graph = std::make_shared<const kg_compiler::NavGraph>(graph);
  made.staging = {false, true};
  return made;
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
  edge.turn_rad = 2.5;
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
  const kg_msgs::NavGraph message = ToMessage(Made(graph));
  EXPECT_FALSE(message.edges.at(0).staging);
  EXPECT_TRUE(message.edges.at(1).staging);
  const kg_engine::AgentGraph made = FromMessage(message);
  EXPECT_EQ(made.made_s, 1.75e9);
  EXPECT_EQ(made.world_version, 8u);
  EXPECT_EQ(made.cycle, 9u);
  EXPECT_EQ(made.agent, "alpha");
  EXPECT_EQ(made.staging, (std::vector<bool>{false, true}));
  const kg_compiler::NavGraph& back = *made.graph;
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
  EXPECT_EQ(a.turn_rad, b.turn_rad);
  EXPECT_EQ(a.via, b.via);
  EXPECT_EQ(2u, b.flight.track.size());
  EXPECT_EQ(kg_compiler::MovementMode::kEdges, back.movement_mode);
  ASSERT_EQ(1u, back.inner_edges.size());
  EXPECT_EQ(0, back.inner_edges[0].from);
  EXPECT_EQ(1, back.inner_edges[0].to);
}

TEST(ConversionTest, RefusesAWaypointGraphThatMakesNoSense) {
  const kg_msgs::NavGraph good = ToMessage(Made(SmallGraph()));
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
  message.edges[2].from = 2;  // The window has two waypoints.
  EXPECT_THROW(FromMessage(message), InputError);
  message = good;
  message.edges[1].via[0] = 2;
  EXPECT_THROW(FromMessage(message), InputError);
  message = good;
  message.movement_mode = "leaps";
  EXPECT_THROW(FromMessage(message), InputError);
}

}  // namespace
}  // namespace kg_ros
