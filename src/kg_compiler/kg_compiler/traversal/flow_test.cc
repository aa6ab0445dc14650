#include "kg_compiler/traversal/flow.h"

#include <gtest/gtest.h>

#include "kg_compiler/testing/test_world.h"
#include "kg_compiler/traversal/sight.h"
#include "kg_compiler/traversal/testing/test_flow_world.h"

namespace kg_compiler {
namespace {

// A random world with land and a field of two random slices.
TestFlowWorld RandomSea(std::mt19937& rng) {
  TestFlowWorld sea(
      RandomFlow(rng, UnevenGrid(rng, 20, 25), 0.8, 7200, kDay_s));
  for (std::size_t i = 0; i < sea.open.size(); ++i) {
    if (Uniform(rng, 0, 1) > 0.03) continue;
    for (kg_base::FieldSlice& slice : sea.field.slices) {
      slice.east_mps[i] = slice.north_mps[i] = kGap;
    }
  }
  return sea;
}

TEST(FlowSampler, IsTheFieldSampledTimesTheBoost) {
  std::mt19937 rng(1);
  int compared = 0;
  for (int round = 0; round < 10; ++round) {
    const TestFlowWorld sea = RandomSea(rng);
    MotionModel motion = Glider(0.5);
    motion.boost_gain = 0.7;
    const VoyageRequest voyage =
        sea.From(motion, {{-91, 23.4}, 5000.0, kDay_s});
    const FlowSampler flow(voyage);
    for (int k = 0; k < 500; ++k) {
      const kg_base::GridPoint at{Uniform(rng, -0.5, 19.5),
                                  Uniform(rng, -0.5, 24.5)};
      const double time_s = Uniform(rng, -9e3, 9e4);
      const auto wanted = sea.field.Sample(at, 5000.0 + time_s);
      if (!wanted) continue;
      const FlowSampler::Sample got = flow(flow.At(time_s), at.col, at.row);
      ASSERT_NEAR(0.7 * wanted->east_mps, got.east, 1e-9);
      ASSERT_NEAR(0.7 * wanted->north_mps, got.north, 1e-9);
      ++compared;
    }
  }
  EXPECT_GT(compared, 4000);
}

TEST(FlowSampler, HasTheGradientsOfTheFieldWithinAPatch) {
  std::mt19937 rng(2);
  const TestFlowWorld sea = RandomSea(rng);
  const VoyageRequest voyage =
      sea.From(Glider(0.5), {{-91, 23.4}, 0.0, kDay_s});
  const FlowSampler flow(voyage);
  const double d = 1e-4;
  for (int k = 0; k < 500; ++k) {
    const double col = std::floor(Uniform(rng, 0, 23)) + 0.3;
    const double row = std::floor(Uniform(rng, 0, 18)) + 0.6;
    const FlowSampler::Moment t = flow.At(Uniform(rng, 0, kDay_s));
    const FlowSampler::Sample at = flow(t, col, row);
    const FlowSampler::Sample e = flow(t, col + d, row),
                              n = flow(t, col, row + d);
    ASSERT_NEAR((e.east - at.east) / d, at.east_col, 1e-6);
    ASSERT_NEAR((e.north - at.north) / d, at.north_col, 1e-6);
    ASSERT_NEAR((n.east - at.east) / d, at.east_row, 1e-6);
    ASSERT_NEAR((n.north - at.north) / d, at.north_row, 1e-6);
    ASSERT_NEAR((n.lon_per_m - at.lon_per_m) / d, at.lon_per_m_row, 1e-9);
  }
}

// Extremals leave the grid, and a search for a time may leave the slices.
TEST(FlowSampler, IsDefinedForEveryPositionAndTime) {
  std::mt19937 rng(4);
  const TestFlowWorld sea = RandomSea(rng);
  const VoyageRequest voyage =
      sea.From(Glider(0.5), {{-91, 23.4}, 0.0, kDay_s});
  const FlowSampler flow(voyage);
  for (const double far : {25.0, 1e3, 3e9, 1e300, HUGE_VAL}) {
    for (const double time_s : {-HUGE_VAL, -1e300, 1e300, HUGE_VAL}) {
      const FlowSampler::Moment moment = flow.At(time_s);
      const FlowSampler::Moment nearest = flow.At(time_s < 0 ? -1 : 9 * kDay_s);
      EXPECT_EQ(flow(nearest, 24, 7.3).east, flow(moment, far, 7.3).east);
      EXPECT_EQ(flow(nearest, 0, 7.3).east, flow(moment, -far, 7.3).east);
      EXPECT_EQ(flow(nearest, 8.1, 19).north, flow(moment, 8.1, far).north);
      EXPECT_EQ(flow(nearest, 8.1, 0).north, flow(moment, 8.1, -far).north);
      EXPECT_EQ(0.0, flow(moment, far, 7.3).east_col);
      EXPECT_EQ(0.0, flow(moment, 8.1, -far).north_row);
    }
    EXPECT_EQ(flow.DegPerCol(23.5), flow.DegPerCol(far));
    EXPECT_EQ(flow.DegPerRow(0.5), flow.DegPerRow(-far));
  }
  EXPECT_TRUE(std::isnan(flow(flow.At(0.0), kGap, 7.3).east));
  EXPECT_TRUE(std::isnan(flow(flow.At(0.0), 8.1, kGap).north));
  EXPECT_EQ(flow(flow.At(9 * kDay_s), 8.1, 7.3).east,
            flow(flow.At(kGap), 8.1, 7.3).east);
  EXPECT_TRUE(IsWithin(flow.felt(), WholeGrid(sea.field.grid)));
}

TEST(FlowSampler, KnowsWhichCellsItWasAskedFor) {
  std::mt19937 rng(3);
  const TestFlowWorld sea = RandomSea(rng);
  const VoyageRequest voyage =
      sea.From(Glider(0.5), {{-91, 23.4}, 0.0, kDay_s});
  const FlowSampler flow(voyage);
  flow(flow.At(0.0), 3.2, 7.9);
  flow(flow.At(0.0), 5.0, 6.1);
  EXPECT_EQ(3, flow.felt().col);
  EXPECT_EQ(7, flow.felt().col_end);
  EXPECT_EQ(6, flow.felt().row);
  EXPECT_EQ(9, flow.felt().row_end);
}

}  // namespace
}  // namespace kg_compiler
