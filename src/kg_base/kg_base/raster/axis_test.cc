#include "kg_base/raster/axis.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

namespace kg_base {
namespace {

// Definition of Locate: binary search and division.
double LocateByDefinition(const std::vector<double>& centres, double x) {
  const auto after = std::upper_bound(centres.begin(), centres.end(), x);
  const long i = std::clamp<long>(after - centres.begin() - 1, 0,
                                  static_cast<long>(centres.size()) - 2);
  return i + (x - centres[i]) / (centres[i + 1] - centres[i]);
}

std::vector<double> Even(int size, double first, double step) {
  std::vector<double> centres;
  for (int i = 0; i < size; ++i) centres.push_back(first + i * step);
  return centres;
}

std::vector<double> MercatorRows(int size) {
  std::vector<double> centres;
  for (int i = 0; i < size; ++i) {
    const double y = 0.3 + 0.04 * M_PI / 180 * i;
    centres.push_back(std::atan(std::sinh(y)) * 180 / M_PI);
  }
  return centres;
}

std::vector<double> RandomAscending(int size, unsigned seed) {
  std::mt19937 random(seed);
  std::exponential_distribution<double> step(1.0);
  std::vector<double> centres{-40.0};
  while (static_cast<int>(centres.size()) < size) {
    centres.push_back(centres.back() + 1e-6 + std::pow(step(random), 3.0));
  }
  return centres;
}

std::vector<double> WithFloatNoise(std::vector<double> centres) {
  for (double& c : centres) c = static_cast<float>(c);
  return centres;
}

void ExpectLocatesAsDefined(const std::vector<double>& centres) {
  const Axis axis(centres);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> anywhere(axis.low(), axis.high());
  for (int i = 0; i < 20000; ++i) {
    const double x = anywhere(random);
    const double expected = LocateByDefinition(centres, x);
    ASSERT_TRUE(axis.Locate(x));
    ASSERT_NEAR(*axis.Locate(x), expected, 1e-12 * (1 + std::abs(expected)));
    ASSERT_NEAR(axis.At(*axis.Locate(x)), x, 1e-11);
  }
  for (std::size_t i = 0; i < centres.size(); ++i) {
    EXPECT_EQ(*axis.Locate(centres[i]), static_cast<double>(i));
    EXPECT_EQ(axis.At(static_cast<double>(i)), centres[i]);
  }
}

TEST(Axis, LocatesAsASearchDoesOnEvenSpacing) {
  ExpectLocatesAsDefined(Even(541, -98.0, 0.04));
  ExpectLocatesAsDefined(Even(2, 0.0, 1.0));
}

TEST(Axis, LocatesAsASearchDoesOnEvenSpacingWithFloatNoise) {
  ExpectLocatesAsDefined(WithFloatNoise(Even(541, -98.0, 0.04)));
}

TEST(Axis, LocatesAsASearchDoesOnMercatorRows) {
  ExpectLocatesAsDefined(MercatorRows(385));
}

TEST(Axis, LocatesAsASearchDoesOnWildSpacing) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    ExpectLocatesAsDefined(RandomAscending(50, seed));
  }
}

TEST(Axis, ReachesHalfACellBeyondTheOuterCentres) {
  const Axis axis({0.0, 1.0, 3.0});
  EXPECT_EQ(axis.low(), -0.5);
  EXPECT_EQ(axis.high(), 4.0);
  EXPECT_EQ(*axis.Locate(-0.5), -0.5);
  EXPECT_EQ(*axis.Locate(4.0), 2.5);
  EXPECT_FALSE(axis.Locate(std::nextafter(-0.5, -1.0)));
  EXPECT_FALSE(axis.Locate(std::nextafter(4.0, 5.0)));
}

TEST(Axis, LocatesNeitherNanNorInfinity) {
  const Axis axis({0.0, 1.0});
  EXPECT_FALSE(axis.Locate(std::numeric_limits<double>::quiet_NaN()));
  EXPECT_FALSE(axis.Locate(std::numeric_limits<double>::infinity()));
  EXPECT_FALSE(axis.Locate(-std::numeric_limits<double>::infinity()));
}

TEST(Axis, AnEmptyOneHoldsNothing) {
  EXPECT_FALSE(Axis().Locate(0.0));
  EXPECT_TRUE(Axis().centres().empty());
}

TEST(Axis, SpacingIsTheMeanOverHalfACellOnEitherSide) {
  const Axis axis({0.0, 1.0, 3.0});
  EXPECT_DOUBLE_EQ(axis.Spacing(0.0), 1.0);
  EXPECT_DOUBLE_EQ(axis.Spacing(1.0), 1.5);
  EXPECT_DOUBLE_EQ(axis.Spacing(1.5), 2.0);
  EXPECT_DOUBLE_EQ(axis.Spacing(2.0), 2.0);
}

TEST(Axis, RefusesWhatDoesNotAscend) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_THROW(Axis(std::vector<double>{}), std::logic_error);
  EXPECT_THROW(Axis(std::vector<double>{1.0}), std::logic_error);
  EXPECT_THROW(Axis({1.0, 1.0}), std::logic_error);
  EXPECT_THROW(Axis({1.0, 0.0}), std::logic_error);
  EXPECT_THROW(Axis({0.0, nan}), std::logic_error);
  EXPECT_THROW(Axis({nan, 1.0}), std::logic_error);
  EXPECT_THROW(Axis({0.0, inf}), std::logic_error);
}

}  // namespace
}  // namespace kg_base
