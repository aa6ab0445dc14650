#include "kg_ros/simulation/agent_simulator.h"

#include <cmath>

#include "gtest/gtest.h"
#include "kg_core/base/units.h"
#include "kg_ros/conversion/message_units.h"

namespace kg_ros {
namespace {

constexpr double kBegin_s = 1000000.0;
constexpr double kWindow_s = 86400.0;

kg_msgs::World TwoDays(std::uint8_t plan_status, int current_window = 1) {
  kg_msgs::World world;
  world.current_window = current_window;
  world.plan_status = plan_status;
  world.mission_time = ToRosTime(kBegin_s);
  for (int i = 0; i < 2; ++i) {
    kg_msgs::WindowInfo window;
    window.index = i;
    window.begin = ToRosTime(kBegin_s + i * kWindow_s);
    window.end = ToRosTime(kBegin_s + (i + 1) * kWindow_s);
    world.windows.push_back(window);
  }
  world.agents.resize(1);
  world.agents[0].id = "alpha";
  return world;
}

// Due east along the equator, one degree a day, 3 kJ a day.
kg_msgs::Assignments Eastward() {
  kg_msgs::Assignments plan;
  plan.assignments.resize(1);
  plan.assignments[0].agent = "alpha";
  kg_msgs::Pathlet& pathlet = plan.assignments[0].pathlet;
  pathlet.track.resize(2);
  pathlet.track[0].stamp = ToRosTime(kBegin_s);
  pathlet.track[1].stamp = ToRosTime(kBegin_s + 2 * kWindow_s);
  pathlet.track[1].lon_rad = kg_core::DegToRad(2.0);
  pathlet.visits.resize(2);
  for (int i = 0; i < 2; ++i) {
    pathlet.visits[i].window = i;
    pathlet.visits[i].cost.energy_j = 3000.0;
  }
  return plan;
}

TEST(AgentSimulatorTest, FollowsTheTrackAndCountsEnergyDown) {
  AgentSimulator simulator(3600.0);
  simulator.Take(TwoDays(kg_msgs::World::PLAN_OK));
  simulator.Take(Eastward());
  kg_msgs::SeamRules rules;
  rules.agent = "alpha";
  rules.energy_budget_j = 10000.0;
  simulator.Take(rules);
  const auto states = simulator.Advance(36.0);  // One day and a half.
  ASSERT_EQ(states.size(), 1u);
  EXPECT_NEAR(kg_core::RadToDeg(states[0].lon_rad), 1.5, 1e-6);
  EXPECT_NEAR(states[0].heading_rad, kg_core::kPi / 2.0, 1e-6);
  EXPECT_NEAR(states[0].energy_left_j, 10000.0 - 4500.0, 1e-3);
  EXPECT_NEAR(states[0].speed_mps, 111319.5 / kWindow_s, 1e-3);
}

TEST(AgentSimulatorTest, TimeStandsStillWhileThePlanIsStale) {
  AgentSimulator simulator(3600.0);
  simulator.Take(TwoDays(kg_msgs::World::PLAN_STALE));
  simulator.Take(Eastward());
  EXPECT_TRUE(simulator.Advance(10.0).empty());
  simulator.Take(TwoDays(kg_msgs::World::PLAN_OK));
  EXPECT_EQ(simulator.Advance(0.0).at(0).header.stamp, ToRosTime(kBegin_s));
}

TEST(AgentSimulatorTest, WaitsForTheTracksOfTheWorldsPlan) {
  AgentSimulator simulator(3600.0);
  kg_msgs::World world = TwoDays(kg_msgs::World::PLAN_OK);
  world.plan_run = 2;
  kg_msgs::Assignments plan = Eastward();
  plan.plan_run = 1;
  simulator.Take(world);
  simulator.Take(plan);
  EXPECT_TRUE(simulator.Advance(1.0).empty());
  plan.plan_run = 2;
  simulator.Take(plan);
  EXPECT_EQ(simulator.Advance(1.0).size(), 1u);
}

TEST(AgentSimulatorTest, GoesOnAlongTheLastPlanWhenPlanningFailed) {
  AgentSimulator simulator(3600.0);
  simulator.Take(TwoDays(kg_msgs::World::PLAN_FAILED));
  simulator.Take(Eastward());
  EXPECT_EQ(simulator.Advance(1.0).size(), 1u);
}

TEST(AgentSimulatorTest, WaitsAtAWindowsEndForTheWorld) {
  AgentSimulator simulator(3600.0);
  simulator.Take(TwoDays(kg_msgs::World::PLAN_OK, 0));
  simulator.Take(Eastward());
  EXPECT_EQ(simulator.Advance(30.0).at(0).header.stamp,
            ToRosTime(kBegin_s + kWindow_s));
  EXPECT_TRUE(simulator.Advance(1.0).empty());
  simulator.Take(TwoDays(kg_msgs::World::PLAN_OK, 1));
  EXPECT_EQ(simulator.Advance(1.0).at(0).header.stamp,
            ToRosTime(kBegin_s + kWindow_s + 3600.0));
}

TEST(AgentSimulatorTest, FollowsAPlanThatBeganAMomentAgoFromItsBegin) {
  AgentSimulator simulator(3600.0);
  simulator.Take(TwoDays(kg_msgs::World::PLAN_OK));
  simulator.Take(Eastward());
  simulator.Advance(0.5);  // Half an hour of mission time.
  simulator.Take(Eastward());
  EXPECT_EQ(simulator.Advance(0.0).at(0).header.stamp, ToRosTime(kBegin_s));
  simulator.Advance(5.0);
  simulator.Take(Eastward());  // The same plan again, long ago: goes on.
  EXPECT_EQ(simulator.Advance(0.0).at(0).header.stamp,
            ToRosTime(kBegin_s + 5.0 * 3600.0));
}

TEST(AgentSimulatorTest, StopsWhenTheMissionEnds) {
  AgentSimulator simulator(3600.0);
  simulator.Take(TwoDays(kg_msgs::World::PLAN_OK));
  simulator.Take(Eastward());
  const auto last = simulator.Advance(1000.0);
  ASSERT_EQ(last.size(), 1u);
  EXPECT_EQ(last[0].header.stamp, ToRosTime(kBegin_s + 2 * kWindow_s));
  EXPECT_TRUE(simulator.Advance(1.0).empty());
}

}  // namespace
}  // namespace kg_ros
