// The selector's rounds, without ROS: cycles, late answers, dead planners.

#include "kg_ros/selection/selector_server.h"

#include <cmath>

#include "gtest/gtest.h"
#include "kg_core/base/input_error.h"
#include "kg_core/base/units.h"
#include "ros/time.h"

namespace kg_ros {
namespace {

constexpr double kSeparation_m = 1000.0;

kg_msgs::CoordinationRules Rules(std::uint64_t cycle) {
  kg_msgs::CoordinationRules rules;
  rules.world_version = 3;
  rules.cycle = cycle;
  rules.agents = {"alpha", "bravo"};
  rules.energy_budget_j = {1e6, 1e6};
  rules.mode = "greedy";
  rules.auction_epsilon = 0.05;
  rules.fairness = "scarcity";
  rules.separation_m = kSeparation_m;
  rules.separation_is_hard = true;
  rules.max_rounds = 5;
  return rules;
}

// A path that stays at one longitude for an hour.
kg_msgs::Pathlet StayAt(double lon_deg, double reward) {
  kg_msgs::Pathlet pathlet;
  pathlet.reward = reward;
  pathlet.visits.resize(1);
  pathlet.visits[0].lon_rad = kg_core::DegToRad(lon_deg);
  pathlet.track.resize(2);
  for (kg_msgs::TimedPoint& point : pathlet.track) {
    point.lon_rad = kg_core::DegToRad(lon_deg);
  }
  pathlet.track[0].stamp = ros::Time(1000.0);
  pathlet.track[1].stamp = ros::Time(4600.0);
  return pathlet;
}

kg_msgs::Candidates Offer(const std::string& agent, std::uint64_t cycle,
                          std::uint32_t round, const kg_msgs::Pathlet& best) {
  kg_msgs::Candidates candidates;
  candidates.agent = agent;
  candidates.agent_iri = "ex:" + agent;
  candidates.cycle = cycle;
  candidates.round = round;
  candidates.pathlets = {best};
  return candidates;
}

class SelectorServerTest : public testing::Test {
 protected:
  SelectorServerTest() { ros::Time::init(); }
};

TEST_F(SelectorServerTest, CommitsWhenEverybodyHasAnswered) {
  SelectorServer server;
  server.KnowRun(6);
  server.Take(Rules(1));
  EXPECT_FALSE(server.Take(Offer("alpha", 1, 0, StayAt(-90, 5))).assignments);
  const SelectorAnswer answer =
      server.Take(Offer("bravo", 1, 0, StayAt(-80, 4)));
  ASSERT_TRUE(answer.assignments);
  EXPECT_EQ(answer.assignments->plan_run, 7u);
  EXPECT_EQ(answer.assignments->reward, 9.0);
  ASSERT_TRUE(answer.rejections);
  EXPECT_EQ(answer.rejections->round, 0u);
}

TEST_F(SelectorServerTest, AsksWhoIsInTheWayToPlanAgain) {
  SelectorServer server;
  server.KnowRun(0);
  server.Take(Rules(1));
  server.Take(Offer("alpha", 1, 0, StayAt(-90, 5)));
  const SelectorAnswer asked =
      server.Take(Offer("bravo", 1, 0, StayAt(-90, 4)));
  ASSERT_FALSE(asked.assignments);
  ASSERT_TRUE(asked.rejections);
  EXPECT_EQ(asked.rejections->round, 1u);
  EXPECT_EQ(asked.rejections->asked, std::vector<std::string>{"bravo"});
  ASSERT_EQ(asked.rejections->cooling.size(), 1u);
  EXPECT_EQ(asked.rejections->cooling[0].agent, "bravo");
  EXPECT_EQ(asked.rejections->cooling[0].by_agent, "alpha");
  EXPECT_EQ(asked.rejections->cooling[0].separation_m, kSeparation_m);
  const SelectorAnswer done = server.Take(Offer("bravo", 1, 1, StayAt(-80, 3)));
  ASSERT_TRUE(done.assignments);
  EXPECT_EQ(done.assignments->reward, 8.0);
  ASSERT_EQ(done.rejections->rejections.size(), 1u);
  EXPECT_EQ(done.rejections->rejections[0].kind, "separation");
  EXPECT_EQ(done.rejections->rejections[0].to_agent, "alpha");
}

TEST_F(SelectorServerTest, RulesThatMakeNoSenseChangeNothing) {
  SelectorServer server;
  server.KnowRun(0);
  server.Take(Rules(1));
  server.Take(Offer("alpha", 1, 0, StayAt(-90, 5)));
  for (const char* mode : {"lottery", ""}) {
    kg_msgs::CoordinationRules bad = Rules(2);
    bad.mode = mode;
    EXPECT_THROW(server.Take(bad), kg_core::InputError);
  }
  EXPECT_EQ(server.WaitingFor(), std::vector<std::string>{"bravo"});
  EXPECT_TRUE(server.Take(Offer("bravo", 1, 0, StayAt(-80, 4))).assignments);
}

TEST_F(SelectorServerTest, CandidatesThatMakeNoSenseAreNotKept) {
  SelectorServer server;
  server.KnowRun(0);
  server.Take(Offer("bravo", 1, 0, StayAt(-80, 4)));
  EXPECT_THROW(server.Take(Offer("alpha", 1, 0, StayAt(-90, NAN))),
               kg_core::InputError);
  EXPECT_FALSE(server.Take(Rules(1)).assignments);
  EXPECT_EQ(server.WaitingFor(), std::vector<std::string>{"alpha"});
  EXPECT_TRUE(server.Take(Offer("alpha", 1, 0, StayAt(-90, 5))).assignments);
}

TEST_F(SelectorServerTest, SaysHowMuchOfThePlanBeforeIsKept) {
  SelectorServer server;
  server.KnowRun(0);
  const auto plan = [&](std::uint64_t cycle, double bravo_lon_deg) {
    server.Take(Rules(cycle));
    server.Take(Offer("alpha", cycle, 0, StayAt(-90, 5)));
    return *server.Take(Offer("bravo", cycle, 0, StayAt(bravo_lon_deg, 4)))
                .assignments;
  };
  const kg_msgs::Assignments first = plan(1, -80);
  EXPECT_TRUE(std::isnan(first.stability));
  EXPECT_TRUE(std::isnan(first.displacement_m));
  const kg_msgs::Assignments same = plan(2, -80);
  EXPECT_EQ(same.stability, 1.0);
  EXPECT_EQ(same.displacement_m, 0.0);
  const kg_msgs::Assignments moved = plan(3, -81);
  EXPECT_EQ(moved.stability, 0.5);
  EXPECT_NEAR(moved.displacement_m, 0.5 * 111.3e3, 100.0);  // On the equator.
  EXPECT_EQ(plan(4, -81).stability, 1.0);  // Against the last one committed.
}

TEST_F(SelectorServerTest, APlanSaysItsModeAndBound) {
  SelectorServer server;
  server.KnowRun(0);
  server.Take(Rules(1));
  kg_msgs::Candidates alpha = Offer("alpha", 1, 0, StayAt(-90, 5));
  kg_msgs::Candidates bravo = Offer("bravo", 1, 0, StayAt(-80, 4));
  alpha.proven = bravo.proven = true;
  alpha.bound = 5;
  bravo.bound = 4;
  server.Take(alpha);
  const kg_msgs::Assignments plan = *server.Take(bravo).assignments;
  EXPECT_EQ(plan.mode, "greedy");
  EXPECT_EQ(plan.bound, 9.0);
}

TEST_F(SelectorServerTest, AnswersOfAnotherCycleAreNeverUsed) {
  SelectorServer server;
  server.KnowRun(0);
  server.Take(Offer("alpha", 1, 0, StayAt(-90, 5)));
  server.Take(Offer("bravo", 1, 0, StayAt(-80, 5)));
  EXPECT_FALSE(server.Take(Rules(2)).assignments);
  EXPECT_EQ(server.WaitingFor().size(), 2u);
}

TEST_F(SelectorServerTest, CandidatesMayComeBeforeTheirRules) {
  SelectorServer server;
  server.KnowRun(0);
  server.Take(Offer("alpha", 1, 0, StayAt(-90, 5)));
  server.Take(Offer("bravo", 1, 0, StayAt(-80, 5)));
  EXPECT_TRUE(server.Take(Rules(1)).assignments);
}

TEST_F(SelectorServerTest, DecidesNothingBeforeItKnowsTheLastRun) {
  SelectorServer server;
  server.Take(Offer("alpha", 1, 0, StayAt(-90, 5)));
  server.Take(Offer("bravo", 1, 0, StayAt(-80, 5)));
  EXPECT_FALSE(server.Take(Rules(1)).assignments);
  const SelectorAnswer answer = server.KnowRun(41);
  ASSERT_TRUE(answer.assignments);
  EXPECT_EQ(answer.assignments->plan_run, 42u);
}

TEST_F(SelectorServerTest, GoesOnWithoutTheDeadAndTakesThemBack) {
  SelectorServer server;
  server.KnowRun(0);
  server.Take(Rules(1));
  server.Take(Offer("alpha", 1, 0, StayAt(-90, 5)));
  const SelectorAnswer alone = server.GiveUpWaiting();
  ASSERT_TRUE(alone.assignments);
  EXPECT_EQ(alone.assignments->assignments.size(), 1u);
  ASSERT_EQ(alone.assignments->unassigned.size(), 1u);
  EXPECT_EQ(alone.assignments->unassigned[0].substr(0, 6), "bravo:");
  const SelectorAnswer both = server.Take(Offer("bravo", 1, 0, StayAt(-80, 4)));
  ASSERT_TRUE(both.assignments);
  EXPECT_EQ(both.assignments->assignments.size(), 2u);
  EXPECT_GT(both.assignments->plan_run, alone.assignments->plan_run);
}

TEST_F(SelectorServerTest, ARepeatedAnswerChangesNothing) {
  SelectorServer server;
  server.KnowRun(0);
  server.Take(Rules(1));
  server.Take(Offer("alpha", 1, 0, StayAt(-90, 5)));
  server.Take(Offer("bravo", 1, 0, StayAt(-80, 4)));
  EXPECT_FALSE(server.Take(Offer("bravo", 1, 0, StayAt(-80, 4))).assignments);
}

}  // namespace
}  // namespace kg_ros
