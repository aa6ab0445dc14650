#include "kg_ros/knowledge/plan_status.h"

#include <gtest/gtest.h>

#include <string>

namespace kg_ros {
namespace {

using kg_msgs::World;

constexpr char kMissing[] = "planner for alpha not connected";

TEST(PlanStatus, AMissingNodeMakesThePlanStaleUntilItIsBack) {
  PlanStatus plan;
  plan.Commit("");
  EXPECT_FALSE(plan.SetMissing(""));
  EXPECT_TRUE(plan.SetMissing(kMissing));
  EXPECT_EQ(World::PLAN_STALE, plan.status());
  EXPECT_EQ(kMissing, plan.note());
  EXPECT_FALSE(plan.SetMissing(kMissing));
  EXPECT_TRUE(plan.SetMissing(""));
  EXPECT_TRUE(plan.is_ok());
  EXPECT_EQ("", plan.note());
}

TEST(PlanStatus, AnOldPlanIsNotValidAgainWhileTheNextIsMade) {
  for (const std::string unassigned : {"", "alpha has no path"}) {
    PlanStatus plan;
    plan.Commit(unassigned);
    plan.Expire();  // A window begins.
    EXPECT_FALSE(plan.SetMissing("")) << unassigned;
    EXPECT_EQ(World::PLAN_STALE, plan.status()) << unassigned;
    EXPECT_EQ("", plan.note()) << unassigned;
  }
}

TEST(PlanStatus, ANodeThatReturnsDoesNotUndoAChangeOfFacts) {
  PlanStatus plan;
  plan.Commit("");
  plan.SetMissing(kMissing);
  plan.Expire();
  EXPECT_FALSE(plan.SetMissing(""));
  EXPECT_EQ(World::PLAN_STALE, plan.status());
}

TEST(PlanStatus, AFailureStaysUntilTheNextPlan) {
  PlanStatus plan;
  plan.Fail("no space left");
  EXPECT_FALSE(plan.SetMissing(kMissing));
  EXPECT_FALSE(plan.SetMissing(""));
  EXPECT_EQ(World::PLAN_FAILED, plan.status());
  EXPECT_EQ("no space left", plan.note());
  plan.Commit("");
  EXPECT_TRUE(plan.is_ok());
}

TEST(PlanStatus, WithoutAPlanThereIsNoneToExpire) {
  PlanStatus plan;
  plan.Expire();
  EXPECT_EQ(World::PLAN_NONE, plan.status());
}

}  // namespace
}  // namespace kg_ros
