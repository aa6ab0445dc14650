#include "kg_base/raster/steps.h"

#include <gtest/gtest.h>

#include <vector>

namespace kg_base {
namespace {

TEST(Steps, AreOneFewerThanTheValues) {
  EXPECT_EQ((std::vector<double>{2, -1, 4}), StepsBetween({1, 3, 2, 6}));
  EXPECT_TRUE(StepsBetween({5}).empty());
  EXPECT_TRUE(StepsBetween({}).empty());
}

TEST(Steps, HaveALowerMedian) {
  EXPECT_EQ(7, LowerMedian({7}));
  EXPECT_EQ(1, LowerMedian({9, 1}));
  EXPECT_EQ(3, LowerMedian({9, 1, 3}));
  EXPECT_EQ(3, LowerMedian({9, 1, 3, 5}));
}

}  // namespace
}  // namespace kg_base
