#include "kg_engine/simulation/agent_simulator.h"

#include <cmath>

#include "gtest/gtest.h"
#include "kg_base/common/units.h"

namespace kg_engine {
namespace {

constexpr double kBegin_s = 1000000.0;
constexpr double kWindow_s = 86400.0;

SimulatedWorld TwoDays(bool plan_holds, std::size_t current_window = 1) {
  SimulatedWorld world;
  world.current_window = current_window;
  world.plan_holds = plan_holds;
  world.time_s = kBegin_s;
  world.window_end_s = {kBegin_s + kWindow_s, kBegin_s + 2 * kWindow_s};
  world.agents = {"alpha"};
  return world;
}

// Due east along the equator, one degree per day, 3 kJ per day.
kg_selector::CommittedPlan Eastward() {
  kg_selector::Pathlet pathlet;
  pathlet.agent = "alpha";
  pathlet.track = {{{0.0, 0.0}, kBegin_s},
                   {{2.0, 0.0}, kBegin_s + 2 * kWindow_s}};
  pathlet.visits.resize(2);
  for (int i = 0; i < 2; ++i) {
    pathlet.visits[i].window = i;
    pathlet.visits[i].cost.energy_j = 3000.0;
  }
  kg_selector::CommittedPlan plan;
  plan.assignments = {{"ex:alpha", pathlet}};
  return plan;
}

TEST(AgentSimulatorTest, FollowsTheTrackAndCountsEnergyDown) {
  AgentSimulator simulator(3600.0);
  simulator.Take(TwoDays(true));
  simulator.Take(Eastward());
  simulator.TakeEnergy("alpha", 10000.0);
  const auto states = simulator.Advance(36.0);  // One day and a half.
  ASSERT_EQ(states.size(), 1u);
  EXPECT_NEAR(states[0].position.lon_deg, 1.5, 1e-6);
  EXPECT_NEAR(states[0].heading_rad, kg_base::kPi / 2.0, 1e-6);
  EXPECT_NEAR(states[0].energy_left_j, 10000.0 - 4500.0, 1e-3);
  EXPECT_NEAR(states[0].speed_mps, 111319.5 / kWindow_s, 1e-3);
}

TEST(AgentSimulatorTest, TimeStandsStillWhileThePlanIsStale) {
  AgentSimulator simulator(3600.0);
  simulator.Take(TwoDays(false));
  simulator.Take(Eastward());
  EXPECT_TRUE(simulator.Advance(10.0).empty());
  simulator.Take(TwoDays(true));
  EXPECT_EQ(simulator.Advance(0.0).at(0).time_s, kBegin_s);
}

TEST(AgentSimulatorTest, WaitsForTheTracksOfTheWorldsPlan) {
  AgentSimulator simulator(3600.0);
  SimulatedWorld world = TwoDays(true);
  world.plan_run = 2;
  kg_selector::CommittedPlan plan = Eastward();
  plan.run = 1;
  simulator.Take(world);
  simulator.Take(plan);
  EXPECT_TRUE(simulator.Advance(1.0).empty());
  plan.run = 2;
  simulator.Take(plan);
  EXPECT_EQ(simulator.Advance(1.0).size(), 1u);
}

TEST(AgentSimulatorTest, WaitsAtAWindowsEndForTheWorld) {
  AgentSimulator simulator(3600.0);
  simulator.Take(TwoDays(true, 0));
  simulator.Take(Eastward());
  EXPECT_EQ(simulator.Advance(30.0).at(0).time_s, kBegin_s + kWindow_s);
  EXPECT_TRUE(simulator.Advance(1.0).empty());
  simulator.Take(TwoDays(true, 1));
  EXPECT_EQ(simulator.Advance(1.0).at(0).time_s, kBegin_s + kWindow_s + 3600.0);
}

TEST(AgentSimulatorTest, FollowsAPlanThatBeganAMomentAgoFromItsBegin) {
  AgentSimulator simulator(3600.0);
  simulator.Take(TwoDays(true));
  simulator.Take(Eastward());
  simulator.Advance(0.5);  // Half an hour of mission time.
  simulator.Take(Eastward());
  EXPECT_EQ(simulator.Advance(0.0).at(0).time_s, kBegin_s);
  simulator.Advance(5.0);
  simulator.Take(Eastward());  // The same plan again: continues.
  EXPECT_EQ(simulator.Advance(0.0).at(0).time_s, kBegin_s + 5.0 * 3600.0);
}

TEST(AgentSimulatorTest, StopsWhenTheMissionEnds) {
  AgentSimulator simulator(3600.0);
  simulator.Take(TwoDays(true));
  simulator.Take(Eastward());
  const auto last = simulator.Advance(1000.0);
  ASSERT_EQ(last.size(), 1u);
  EXPECT_EQ(last[0].time_s, kBegin_s + 2 * kWindow_s);
  EXPECT_TRUE(simulator.Advance(1.0).empty());
}

}  // namespace
}  // namespace kg_engine
