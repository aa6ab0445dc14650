#include "kg_base/raster/vector_field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace kg_base {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

VectorField RandomField(int slices, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> flow(-2, 2);
  std::uniform_real_distribution<double> step(10, 1000);
  VectorField field;
  field.grid = Grid({0, 1, 2, 3, 4}, {0, 1, 2, 3});
  double time_s = 1000.0;
  for (int s = 0; s < slices; ++s) {
    FieldSlice slice{time_s, Raster(20), Raster(20)};
    for (float& v : slice.east_mps) v = flow(random);
    for (float& v : slice.north_mps) v = flow(random);
    field.slices.push_back(slice);
    time_s += step(random);
  }
  return field;
}

// Definition of the sample: bilinear with a missing corner as no flow.
double BilinearByHand(const Raster& values, const Raster& other, GridPoint at) {
  double sum = 0.0;
  for (int row = 0; row < 4; ++row) {
    for (int col = 0; col < 5; ++col) {
      const double r = std::min(std::max(at.row, 0.0), 3.0);
      const double c = std::min(std::max(at.col, 0.0), 4.0);
      const double weight = std::max(0.0, 1 - std::abs(r - row)) *
                            std::max(0.0, 1 - std::abs(c - col));
      const std::size_t i = row * 5 + col;
      if (weight > 0 && !std::isnan(values[i]) && !std::isnan(other[i])) {
        sum += weight * values[i];
      }
    }
  }
  return sum;
}

TEST(VectorField, SamplesBilinearlyInSpaceAndLinearlyInTime) {
  const VectorField field = RandomField(6, 1);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> row(-0.5, 3.5), col(-0.5, 4.5);
  for (int i = 0; i < 2000; ++i) {
    const GridPoint at{row(random), col(random)};
    const int s = i % 5;
    const double share = (i % 11) / 10.0;
    const FieldSlice& a = field.slices[s];
    const FieldSlice& b = field.slices[s + 1];
    const auto got = field.Sample(at, a.time_s + share * (b.time_s - a.time_s));
    ASSERT_TRUE(got);
    EXPECT_NEAR(got->east_mps,
                (1 - share) * BilinearByHand(a.east_mps, a.north_mps, at) +
                    share * BilinearByHand(b.east_mps, b.north_mps, at),
                1e-12);
    EXPECT_NEAR(got->north_mps,
                (1 - share) * BilinearByHand(a.north_mps, a.east_mps, at) +
                    share * BilinearByHand(b.north_mps, b.east_mps, at),
                1e-12);
  }
}

TEST(VectorField, TheNearestSliceHoldsBeforeTheFirstAndAfterTheLast) {
  const VectorField field = RandomField(3, 3);
  const GridPoint at{1.3, 2.6};
  const auto first = field.Sample(at, field.slices.front().time_s);
  const auto last = field.Sample(at, field.slices.back().time_s);
  EXPECT_EQ(field.Sample(at, -1e12)->east_mps, first->east_mps);
  EXPECT_EQ(field.Sample(at, 1e12)->north_mps, last->north_mps);
  EXPECT_NE(first->east_mps, last->east_mps);
}

TEST(VectorField, OneSliceHoldsForEver) {
  const VectorField field = RandomField(1, 4);
  EXPECT_EQ(field.Sample({1, 2}, 0)->east_mps, field.slices[0].east_mps[7]);
  EXPECT_EQ(field.Sample({1, 2}, 1e9)->east_mps, field.slices[0].east_mps[7]);
}

TEST(VectorField, IsUnknownInACellWithoutData) {
  VectorField field = RandomField(1, 5);
  field.slices[0].east_mps[7] = kNan;  // Row 1, column 2; north has a value.
  EXPECT_FALSE(field.Sample({1, 2}, 0));
  EXPECT_FALSE(field.Sample({1.4, 1.6}, 0));
  EXPECT_TRUE(field.Sample({1.6, 2.0}, 0));
  EXPECT_TRUE(field.Sample({1.0, 2.6}, 0));
}

TEST(VectorField, AMissingCornerIsWaterAtRest) {
  VectorField field = RandomField(1, 6);
  SharedRaster& east = field.slices[0].east_mps;
  SharedRaster& north = field.slices[0].north_mps;
  north[7] = kNan;
  const auto got = field.Sample({1.75, 2.0}, 0);
  ASSERT_TRUE(got);
  EXPECT_NEAR(got->east_mps, 0.75 * east[12], 1e-12);
  EXPECT_NEAR(got->north_mps, 0.75 * north[12], 1e-12);
}

TEST(VectorField, IsUnknownBetweenSlicesWhereEitherHasNoData) {
  VectorField field = RandomField(2, 7);
  field.slices[1].east_mps[0] = kNan;
  const double begin = field.slices[0].time_s;
  EXPECT_TRUE(field.Sample({0, 0}, begin));
  EXPECT_FALSE(field.Sample({0, 0}, begin + 1.0));
}

TEST(VectorField, IsUnknownOutsideTheGridAndForNan) {
  const VectorField field = RandomField(2, 8);
  EXPECT_TRUE(field.Sample({-0.5, 4.5}, 0));
  EXPECT_FALSE(field.Sample({-0.51, 0}, 0));
  EXPECT_FALSE(field.Sample({0, 4.51}, 0));
  EXPECT_FALSE(field.Sample({kNan, 0}, 0));
  EXPECT_FALSE(field.Sample({0, kNan}, 0));
  EXPECT_FALSE(field.Sample({0, 0}, kNan));
  EXPECT_FALSE(VectorField().Sample({0, 0}, 0));
}

TEST(VectorField, BetweenKeepsWhatSamplingInsideNeeds) {
  const VectorField field = RandomField(20, 9);
  std::mt19937 random(10);
  std::uniform_real_distribution<double> when(0, field.slices[19].time_s + 900);
  for (int i = 0; i < 200; ++i) {
    double begin = when(random), end = when(random);
    if (begin > end) std::swap(begin, end);
    const VectorField part = field.Between(begin, end);
    for (const double share : {0.0, 0.3, 0.5, 1.0}) {
      const double time_s = begin + share * (end - begin);
      const auto whole = field.Sample({1.2, 3.4}, time_s);
      const auto some = part.Sample({1.2, 3.4}, time_s);
      ASSERT_TRUE(whole && some);
      EXPECT_EQ(whole->east_mps, some->east_mps);
      EXPECT_EQ(whole->north_mps, some->north_mps);
    }
    int outside = 0;
    for (const FieldSlice& s : part.slices) {
      outside += s.time_s < begin || s.time_s > end;
    }
    EXPECT_LE(outside, 2);
  }
}

TEST(VectorField, NoDataIsLandInAnySlice) {
  VectorField field = RandomField(3, 11);
  field.slices[0].east_mps[3] = kNan;
  field.slices[2].north_mps[9] = kNan;
  const Mask land = field.NoData();
  for (std::size_t i = 0; i < land.size(); ++i) {
    EXPECT_EQ(land[i], i == 3 || i == 9 ? 1 : 0) << i;
  }
}

TEST(VectorField, MaxSpeedLooksAtWholeVectorsOnly) {
  VectorField field = RandomField(2, 12);
  field.slices[1].east_mps[4] = 3.0f;
  field.slices[1].north_mps[4] = -4.0f;
  field.slices[0].east_mps[5] = 100.0f;
  field.slices[0].north_mps[5] = kNan;
  EXPECT_DOUBLE_EQ(field.MaxSpeed_mps(), 5.0);
}

TEST(VectorField, HashSeesEveryValueAndTime) {
  const VectorField field = RandomField(2, 13);
  EXPECT_EQ(field.Hash(), RandomField(2, 13).Hash());
  VectorField other = field;
  other.slices[1].north_mps[19] += 1e-3f;
  EXPECT_NE(field.Hash(), other.Hash());
  other = field;
  other.slices[1].time_s += 1.0;
  EXPECT_NE(field.Hash(), other.Hash());
}

}  // namespace
}  // namespace kg_base
