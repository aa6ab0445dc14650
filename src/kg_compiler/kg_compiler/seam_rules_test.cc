#include "kg_compiler/seam_rules.h"

#include <gtest/gtest.h>

#include "kg_compiler/test_world.h"

namespace kg_compiler {
namespace {

kg_core::Mission TestMission() {
  kg_core::Mission mission;
  mission.windows = {TestWindow(0, 1.0), TestWindow(1, 0.8),
                     TestWindow(2, 0.6)};
  mission.agents = {TestAgent("alpha")};
  mission.events = {{"ex:e", {-90, 25}, 5.0, 1, 9000.0, {1, 2}}};
  mission.coordination.waypoints_per_window = 50;
  mission.coordination.waypoint_spacing_m = 8000.0;
  return mission;
}

TEST(SeamRules, SpeakSiPerSecondAndJoule) {
  kg_core::Mission mission = TestMission();
  mission.agents[0].policy.lambda_risk = 3.6;           // Per hour.
  mission.agents[0].policy.lambda_time_per_s = 0.001;   // SI in the facts.
  mission.agents[0].policy.lambda_energy_per_j = 1e-6;  // Likewise.
  mission.agents[0].policy.lambda_uncertainty = 0.25;
  const SeamRules rules = CompileSeamRules(mission, mission.agents[0], 0);
  EXPECT_DOUBLE_EQ(0.001, rules.weights.risk_per_s);
  EXPECT_DOUBLE_EQ(0.001, rules.weights.time_per_s);
  EXPECT_DOUBLE_EQ(1e-6, rules.weights.energy_per_j);
  EXPECT_DOUBLE_EQ(0.25, rules.weights.uncertainty);
  EXPECT_DOUBLE_EQ(1e7, rules.energy_budget_j);
  EXPECT_DOUBLE_EQ(12000.0, rules.sensor_radius_m);
  EXPECT_DOUBLE_EQ(8000.0, rules.spacing_m);
}

TEST(SeamRules, TravelAWindowAtCruiseSpeedUnlessAFactSaysOtherwise) {
  kg_core::Mission mission = TestMission();
  kg_core::Agent& agent = mission.agents[0];
  EXPECT_DOUBLE_EQ(
      0.5 * 86400,
      CompileSeamRules(mission, agent, 0).windows[0].base_travel_m);
  agent.capabilities.base_travel_m = 1234.0;
  EXPECT_DOUBLE_EQ(
      1234.0, CompileSeamRules(mission, agent, 0).windows[0].base_travel_m);
}

TEST(SeamRules, KeepAnEventToItsWindowsAndWeighItByConfidenceOnce) {
  const kg_core::Mission mission = TestMission();
  const SeamRules rules = CompileSeamRules(mission, mission.agents[0], 0);
  EXPECT_TRUE(rules.windows[0].events.empty());
  ASSERT_EQ(1u, rules.windows[1].events.size());
  EXPECT_DOUBLE_EQ(5.0 * 0.8, rules.windows[1].events[0].reward);
  EXPECT_DOUBLE_EQ(5.0 * 0.6, rules.windows[2].events[0].reward);
}

TEST(SeamRules, LeaveOutWindowsThatHavePassed) {
  const kg_core::Mission mission = TestMission();
  const SeamRules rules = CompileSeamRules(mission, mission.agents[0], 2);
  ASSERT_EQ(1u, rules.windows.size());
  EXPECT_EQ(2, rules.windows[0].window);
}

TEST(SeamRules, AllowAtMostTwentyWaypointsAWindow) {
  const kg_core::Mission mission = TestMission();
  EXPECT_EQ(20, CompileSeamRules(mission, mission.agents[0], 0).max_waypoints);
}

}  // namespace
}  // namespace kg_compiler
