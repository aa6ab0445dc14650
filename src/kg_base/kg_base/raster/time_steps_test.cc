#include "kg_base/raster/time_steps.h"

#include <gtest/gtest.h>

namespace kg_base {
namespace {

constexpr double kHour_s = 3600.0;

TimeSteps OfHours(std::vector<double> hours) {
  for (double& hour : hours) hour *= kHour_s;
  return FindTimeSteps(hours);
}

TEST(FindTimeSteps, CountsTheStepsThatGapsLeaveOut) {
  const TimeSteps steps = OfHours({0, 6, 12, 30, 36, 54, 60, 66});
  EXPECT_EQ(steps.usual_s, 6 * kHour_s);
  EXPECT_EQ(steps.missing, 4u);
  EXPECT_EQ(steps.gap_begin_s, 12 * kHour_s);
  EXPECT_EQ(steps.gap_end_s, 30 * kHour_s);
}

TEST(FindTimeSteps, TakesMonthsAndRoundedTimesForEvenSteps) {
  EXPECT_EQ(OfHours({0, 31 * 24, 59 * 24, 90 * 24, 120 * 24}).missing, 0u);
  EXPECT_EQ(OfHours({0, 1.0001, 1.9998, 3.0001}).missing, 0u);
}

TEST(FindTimeSteps, KnowsNoStepOfOneTime) {
  EXPECT_EQ(OfHours({}).usual_s, 0.0);
  EXPECT_EQ(OfHours({5}).usual_s, 0.0);
  EXPECT_EQ(OfHours({5, 11}).missing, 0u);
}

TEST(TimeText, HasATextForAnyYear) {
  EXPECT_EQ(TimeText(0.0), "1970-01-01T00:00:00Z");
  EXPECT_NE(TimeText(1e12).find("s since 1970"), std::string::npos);
}

}  // namespace
}  // namespace kg_base
