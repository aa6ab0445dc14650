#include "kg_ros/knowledge/plan_progress.h"

#include "gtest/gtest.h"

namespace kg_ros {
namespace {

template <typename Message>
Message Answer(std::uint64_t cycle, std::uint64_t run) {
  Message message;
  message.cycle = cycle;
  message.plan_run = run;
  return message;
}

TEST(PlanProgressTest, APlanNeedsAssignmentsAndTheEndOfItsRejections) {
  PlanProgress progress;
  progress.Begin(4);
  EXPECT_TRUE(progress.Take(Answer<kg_msgs::Assignments>(4, 9)));
  EXPECT_FALSE(progress.TakeFinishedPlan());
  auto asking = Answer<kg_msgs::Rejections>(4, 9);
  asking.round = 1;
  EXPECT_TRUE(progress.Take(asking));
  EXPECT_FALSE(progress.TakeFinishedPlan());
  EXPECT_TRUE(progress.Take(Answer<kg_msgs::Rejections>(4, 9)));
  EXPECT_TRUE(progress.TakeFinishedPlan());
  EXPECT_FALSE(progress.TakeFinishedPlan());  // Once.
}

TEST(PlanProgressTest, OrderOfArrivalDoesNotMatter) {
  PlanProgress progress;
  progress.Begin(4);
  progress.Take(Answer<kg_msgs::Rejections>(4, 9));
  EXPECT_FALSE(progress.TakeFinishedPlan());
  progress.Take(Answer<kg_msgs::Assignments>(4, 9));
  EXPECT_TRUE(progress.TakeFinishedPlan());
}

TEST(PlanProgressTest, AnswersOfOtherCyclesAreDroppedAndCounted) {
  PlanProgress progress;
  progress.Begin(4);
  EXPECT_FALSE(progress.Take(Answer<kg_msgs::Assignments>(3, 9)));
  kg_msgs::NavGraph graph;
  graph.cycle = 5;
  EXPECT_FALSE(progress.Take(graph));
  EXPECT_EQ(progress.dropped(), 2u);
  EXPECT_EQ(progress.NextUnrecorded(), nullptr);
}

TEST(PlanProgressTest, EveryGraphIsHandedOutOnce) {
  PlanProgress progress;
  progress.Begin(4);
  kg_msgs::NavGraph graph;
  graph.cycle = 4;
  graph.agent = "alpha";
  graph.window = 2;
  progress.Take(graph);
  ASSERT_NE(progress.NextUnrecorded(), nullptr);
  EXPECT_EQ(progress.NextUnrecorded(), nullptr);
  EXPECT_EQ(progress.nav_graphs().size(), 1u);
}

}  // namespace
}  // namespace kg_ros
