#include "kg_engine/state/fleet_state.h"

#include <cmath>
#include <limits>

#include "gtest/gtest.h"

namespace kg_engine {
namespace {

kg_mission::Mission TwoWindows() {
  kg_mission::Mission mission;
  for (int i = 0; i < 2; ++i) {
    kg_mission::TimeWindow window;
    window.index = i;
    window.begin_s = 1000.0 + 100.0 * i;
    window.end_s = window.begin_s + 100.0;
    mission.windows.push_back(window);
  }
  kg_mission::Agent agent;
  agent.id = "alpha";
  agent.start = {-90.0, 25.0};
  agent.capabilities.energy_budget_j = 50.0;
  mission.agents.push_back(agent);
  return mission;
}

AgentPose PoseAt(double time_s, double lon_deg) {
  AgentPose pose;
  pose.position = {lon_deg, 25.0};
  pose.time_s = time_s;
  return pose;
}

TEST(FleetStateTest, StartsWhereTheFactsSay) {
  FleetState fleet;
  fleet.Reset(TwoWindows());
  EXPECT_EQ(fleet.time_s(), 1000.0);
  EXPECT_EQ(fleet.CurrentWindow(TwoWindows()), 0);
  EXPECT_EQ(fleet.poses().at("alpha").position.lon_deg, -90.0);
  EXPECT_EQ(fleet.poses().at("alpha").energy_left_j, 50.0);
}

TEST(FleetStateTest, ALateObservationReplacesNothing) {
  FleetState fleet;
  fleet.Reset(TwoWindows());
  EXPECT_TRUE(fleet.Observe("alpha", PoseAt(1120.0, -89.0)));
  EXPECT_TRUE(fleet.Observe("alpha", PoseAt(1050.0, -80.0)));
  EXPECT_EQ(fleet.poses().at("alpha").position.lon_deg, -89.0);
  EXPECT_EQ(fleet.time_s(), 1120.0);
  EXPECT_EQ(fleet.CurrentWindow(TwoWindows()), 1);
}

TEST(FleetStateTest, IsCompleteWhenEverybodyIsSeenAtTheNewestTime) {
  kg_mission::Mission mission = TwoWindows();
  mission.agents.push_back(mission.agents.front());
  mission.agents.back().id = "bravo";
  FleetState fleet;
  fleet.Reset(mission);
  EXPECT_TRUE(fleet.IsComplete());
  fleet.Observe("alpha", PoseAt(1100.0, -89.0));
  EXPECT_FALSE(fleet.IsComplete());
  fleet.Observe("bravo", PoseAt(1100.0, -89.0));
  EXPECT_TRUE(fleet.IsComplete());
}

TEST(FleetStateTest, UnknownEnergyKeepsTheLastKnown) {
  FleetState fleet;
  fleet.Reset(TwoWindows());
  fleet.Observe("alpha", PoseAt(1010.0, -89.0));
  EXPECT_EQ(fleet.poses().at("alpha").energy_left_j, 50.0);
}

TEST(FleetStateTest, RefusesStrangersAndNonsense) {
  FleetState fleet;
  fleet.Reset(TwoWindows());
  EXPECT_FALSE(fleet.Observe("zulu", PoseAt(1010.0, -89.0)));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(fleet.Observe("alpha", PoseAt(nan, -89.0)));
  EXPECT_FALSE(fleet.Observe("alpha", PoseAt(1010.0, nan)));
  EXPECT_EQ(fleet.time_s(), 1000.0);
}

TEST(FleetStateTest, AfterTheLastWindowTheMissionHasEnded) {
  FleetState fleet;
  fleet.Reset(TwoWindows());
  fleet.Observe("alpha", PoseAt(1200.0, -89.0));
  EXPECT_EQ(fleet.CurrentWindow(TwoWindows()), 2);
}

}  // namespace
}  // namespace kg_engine
