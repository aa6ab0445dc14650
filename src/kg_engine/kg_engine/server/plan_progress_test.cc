#include "kg_engine/server/plan_progress.h"

#include <memory>

#include "gtest/gtest.h"

namespace kg_engine {
namespace {

using kg_selector::CommittedPlan;
using kg_selector::RoundRequest;
using kg_selector::RunEnd;

template <typename Value>
Value Answer(std::uint64_t cycle, std::uint64_t run) {
  Value value;
  value.cycle = cycle;
  value.run = run;
  return value;
}

AgentGraph Graph(std::uint64_t cycle, int window) {
  kg_compiler::NavGraph made;
  made.window = window;
  AgentGraph graph;
  graph.cycle = cycle;
  graph.agent = "alpha";
  graph.graph = std::make_shared<const kg_compiler::NavGraph>(made);
  return graph;
}

TEST(PlanProgressTest, APlanNeedsAssignmentsAndTheEndOfItsRejections) {
  PlanProgress progress;
  progress.Begin(4);
  EXPECT_TRUE(progress.Take(Answer<CommittedPlan>(4, 9)));
  EXPECT_FALSE(progress.TakeFinishedPlan());
  auto asking = Answer<RoundRequest>(4, 9);
  asking.round = 1;
  EXPECT_TRUE(progress.Take(asking));
  EXPECT_FALSE(progress.TakeFinishedPlan());
  EXPECT_TRUE(progress.Take(Answer<RunEnd>(4, 9)));
  EXPECT_TRUE(progress.TakeFinishedPlan());
  EXPECT_FALSE(progress.TakeFinishedPlan());  // Once.
}

TEST(PlanProgressTest, OrderOfArrivalDoesNotMatter) {
  PlanProgress progress;
  progress.Begin(4);
  progress.Take(Answer<RunEnd>(4, 9));
  EXPECT_FALSE(progress.TakeFinishedPlan());
  progress.Take(Answer<CommittedPlan>(4, 9));
  EXPECT_TRUE(progress.TakeFinishedPlan());
}

TEST(PlanProgressTest, AnswersOfOtherCyclesAreDroppedAndCounted) {
  PlanProgress progress;
  progress.Begin(4);
  EXPECT_FALSE(progress.Take(Answer<CommittedPlan>(3, 9)));
  EXPECT_FALSE(progress.Take(Graph(5, 0)));
  EXPECT_EQ(progress.dropped(), 2u);
  EXPECT_EQ(progress.NextUnrecorded(), nullptr);
}

TEST(PlanProgressTest, EveryGraphIsHandedOutOnce) {
  PlanProgress progress;
  progress.Begin(4);
  progress.Take(Graph(4, 2));
  ASSERT_NE(progress.NextUnrecorded(), nullptr);
  EXPECT_EQ(progress.NextUnrecorded(), nullptr);
  EXPECT_EQ(progress.graphs().size(), 1u);
}

}  // namespace
}  // namespace kg_engine
