#include "kg_engine/server/plan_progress.h"

#include <memory>
#include <string>

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
  EXPECT_FALSE(progress.TakeFinishedPlan());  // Returned only once.
}

TEST(PlanProgressTest, OrderOfArrivalDoesNotMatter) {
  PlanProgress progress;
  progress.Begin(4);
  progress.Take(Answer<RunEnd>(4, 9));
  EXPECT_FALSE(progress.TakeFinishedPlan());
  progress.Take(Answer<CommittedPlan>(4, 9));
  EXPECT_TRUE(progress.TakeFinishedPlan());
}

RoundRequest Request(std::uint64_t run, std::uint32_t round, double price) {
  auto request = Answer<RoundRequest>(4, run);
  request.round = round;
  request.prices.resize(1);
  request.prices[0].price = price;
  request.cooling.resize(1);
  request.cooling[0].agent = "bravo";
  request.cooling[0].by_agent = "alpha" + std::to_string(run);
  return request;
}

CommittedPlan Plan(std::uint64_t run, int rounds) {
  auto plan = Answer<CommittedPlan>(4, run);
  plan.rounds = rounds;
  return plan;
}

// Each of the three has a topic of its own.
TEST(PlanProgressTest, APlanWaitsForTheRequestOfItsLastRound) {
  PlanProgress progress;
  progress.Begin(4);
  progress.Take(Plan(9, 2));
  progress.Take(Answer<RunEnd>(4, 9));
  EXPECT_FALSE(progress.TakeFinishedPlan());
  progress.Take(Request(8, 2, 3.0));  // Another run.
  EXPECT_FALSE(progress.TakeFinishedPlan());
  progress.Take(Request(9, 1, 1.0));
  EXPECT_FALSE(progress.TakeFinishedPlan());
  progress.Take(Request(9, 2, 2.0));
  const auto plan = progress.TakeFinishedPlan();
  ASSERT_TRUE(plan);
  const PlanRecord record = progress.MakeRecord(*plan);
  ASSERT_EQ(record.prices.size(), 1u);
  EXPECT_EQ(record.prices[0].price, 2.0);
  ASSERT_EQ(record.cooling.size(), 1u);
  EXPECT_EQ(record.cooling[0].by_agent, "alpha9");
}

TEST(PlanProgressTest, TheNextRunMayAskBeforeTheEndOfThisOneIsHere) {
  PlanProgress progress;
  progress.Begin(4);
  progress.Take(Request(9, 1, 1.0));
  progress.Take(Request(10, 1, 5.0));
  progress.Take(Answer<RunEnd>(4, 9));
  progress.Take(Plan(9, 1));
  const auto plan = progress.TakeFinishedPlan();
  ASSERT_TRUE(plan);
  EXPECT_EQ(progress.MakeRecord(*plan).prices.at(0).price, 1.0);
  EXPECT_EQ(progress.MakeRecord(*plan).cooling.at(0).by_agent, "alpha9");
  progress.Take(Plan(10, 1));
  progress.Take(Answer<RunEnd>(4, 10));
  const auto next = progress.TakeFinishedPlan();
  ASSERT_TRUE(next);
  EXPECT_EQ(progress.MakeRecord(*next).prices.at(0).price, 5.0);
  EXPECT_EQ(progress.MakeRecord(*next).cooling.at(0).by_agent, "alpha10");
}

// Requests arrive in their order: the missing ones of the first run, lost while
// this node was away, will not come any more.
TEST(PlanProgressTest, ARequestOfALaterRunEndsTheWait) {
  PlanProgress progress;
  progress.Begin(4);
  progress.Take(Plan(9, 1));
  progress.Take(Answer<RunEnd>(4, 9));
  EXPECT_FALSE(progress.TakeFinishedPlan());
  progress.Take(Request(10, 1, 5.0));
  const auto plan = progress.TakeFinishedPlan();
  ASSERT_TRUE(plan);
  EXPECT_TRUE(progress.MakeRecord(*plan).prices.empty());
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
