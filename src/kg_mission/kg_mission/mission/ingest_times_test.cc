#include "kg_mission/mission/ingest_times.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "kg_base/common/input_error.h"

namespace kg_mission {
namespace {

using kg_base::InputError;

constexpr double kHour_s = 3600.0;
constexpr double kDay_s = 24 * kHour_s;

TimeWindow Day(int index) {
  return {"w", index, index * kDay_s, (index + 1) * kDay_s, 1.0};
}

// Noon of days first..last; day 0 is that of window 0.
std::vector<double> Noons(int first, int last) {
  std::vector<double> time_s;
  for (int day = first; day <= last; ++day) {
    time_s.push_back((day + 0.5) * kDay_s);
  }
  return time_s;
}

std::string GetRefusal(const std::vector<double>& time_s, int window) {
  try {
    StepsOfDifference(time_s, Day(window));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(IngestTimesTest, DifferenceIsWithTheDayBefore) {
  const StepPair steps = StepsOfDifference(Noons(-1, 6), Day(3));
  EXPECT_EQ(steps.step, 4);
  EXPECT_EQ(steps.previous, 3);
}

TEST(IngestTimesTest, TheFirstWindowMayLookForwardWhereNothingIsBefore) {
  const StepPair backward = StepsOfDifference(Noons(-1, 6), Day(0));
  EXPECT_EQ(backward.step, 1);
  EXPECT_EQ(backward.previous, 0);
  const StepPair forward = StepsOfDifference(Noons(0, 6), Day(0));
  EXPECT_EQ(forward.step, 0);
  EXPECT_EQ(forward.previous, 1);
}

TEST(IngestTimesTest, NWindowsNeedNPlusOneDays) {
  EXPECT_NE(GetRefusal(Noons(0, 0), 0), "");
  EXPECT_EQ(GetRefusal(Noons(-1, 0), 0), "");
  const std::string said = GetRefusal(Noons(-1, 3), 6);
  EXPECT_NE(said.find("too few days: has 5 steps from 1969-12-31T12:00:00Z to "
                      "1970-01-04T12:00:00Z; window 6"),
            std::string::npos)
      << said;
  EXPECT_NE(GetRefusal({}, 0).find("no time steps"), std::string::npos);
}

TEST(IngestTimesTest, AMissingDayIsNotBridged) {
  std::vector<double> time_s = Noons(-1, 6);
  time_s.erase(time_s.begin() + 4);  // The noon of window 3.
  EXPECT_NE(GetRefusal(time_s, 3), "");
  EXPECT_NE(GetRefusal(time_s, 4), "");
  EXPECT_EQ(GetRefusal(time_s, 5), "");
  EXPECT_THROW(StepsOfField(time_s, Day(3)), InputError);
  EXPECT_NO_THROW(StepsOfField(time_s, Day(5)));
}

TEST(IngestTimesTest, FieldsReachBeyondBothEndsOfTheirWindow) {
  const StepRange steps = StepsOfField(Noons(-1, 7), Day(3));
  EXPECT_EQ(steps.first, 3);  // Noon of day 2.
  EXPECT_EQ(steps.last, 5);   // Noon of day 4.
}

TEST(IngestTimesTest, FieldsMayEndHalfADayInsideTheWindow) {
  const StepRange steps = StepsOfField(Noons(0, 6), Day(6));
  EXPECT_EQ(steps.last, 6);
  EXPECT_THROW(StepsOfField(Noons(0, 5), Day(6)), InputError);
  EXPECT_THROW(StepsOfField(Noons(1, 6), Day(0)), InputError);
  EXPECT_THROW(StepsOfField({}, Day(0)), InputError);
}

// The range has every step strictly inside the window, and at most one more on
// either side.
TEST(IngestTimesTest, RandomStepsAreCoveredAndNoMore) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> gap_s(kHour_s, 30 * kHour_s);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<double> time_s = {-kDay_s};
    while (time_s.back() < 9 * kDay_s) {
      time_s.push_back(time_s.back() + gap_s(random));
    }
    const TimeWindow window = Day(trial % 7);
    const StepRange steps = StepsOfField(time_s, window);
    int inside = 0;
    for (int i = 0; i < static_cast<int>(time_s.size()); ++i) {
      const bool is_inside =
          time_s[i] > window.begin_s && time_s[i] < window.end_s;
      inside += is_inside ? 1 : 0;
      if (is_inside) {
        EXPECT_TRUE(steps.first <= i && i <= steps.last);
      }
    }
    EXPECT_LE(time_s[steps.first], window.begin_s);
    EXPECT_GE(time_s[steps.last], window.end_s);
    EXPECT_EQ(steps.last - steps.first + 1, inside + 2);
  }
}

// Compares with a full search for the nearest step.
TEST(IngestTimesTest, StepOfWindowIsTheNearestToItsMiddle) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> gap_s(kHour_s, 9 * kHour_s);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<double> time_s = {0.0};
    while (time_s.back() < 7 * kDay_s) {
      time_s.push_back(time_s.back() + gap_s(random));
    }
    const TimeWindow window = Day(trial % 7);
    const double middle_s = window.begin_s + 0.5 * kDay_s;
    double nearest_s = 1e99;
    for (const double t : time_s) {
      nearest_s = std::min(nearest_s, std::abs(t - middle_s));
    }
    EXPECT_EQ(std::abs(time_s[StepOfWindow(time_s, window)] - middle_s),
              nearest_s);
  }
}

}  // namespace
}  // namespace kg_mission
