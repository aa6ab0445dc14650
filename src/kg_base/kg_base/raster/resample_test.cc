#include "kg_base/raster/resample.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

namespace kg_base {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

Grid UnevenGrid() {
  return Grid({-98, -97.9, -97.7, -97.6}, {21, 21.1, 21.3, 21.6, 21.7});
}

Raster Values(const Grid& grid, double (*value)(LonLat)) {
  Raster raster;
  for (const double lat : grid.lat_deg()) {
    for (const double lon : grid.lon_deg()) {
      raster.push_back(static_cast<float>(value({lon, lat})));
    }
  }
  return raster;
}

TEST(ResampleBilinear, KeepsABilinearFunctionOnAnyGrid) {
  const auto plane = [](LonLat p) { return 3 * p.lon_deg - 2 * p.lat_deg + 1; };
  const Grid from = UnevenGrid();
  const Grid to({-97.95, -97.8, -97.61}, {21.0, 21.15, 21.5, 21.65});
  const Raster got = ResampleBilinear(from, Values(from, plane), to);
  const Raster expected = Values(to, plane);
  ASSERT_EQ(got.size(), expected.size());
  for (std::size_t i = 0; i < got.size(); ++i) {
    EXPECT_NEAR(got[i], expected[i], 1e-4);
  }
}

TEST(ResampleBilinear, OntoTheSameGridChangesNothing) {
  const Grid grid = UnevenGrid();
  std::mt19937 random(9);
  std::uniform_real_distribution<float> any(-5, 5);
  Raster values(grid.size());
  for (float& v : values) v = any(random);
  values[7] = kNan;
  const Raster got = ResampleBilinear(grid, values, grid);
  for (std::size_t i = 0; i < got.size(); ++i) {
    if (i == 7) {
      EXPECT_TRUE(std::isnan(got[i]));
    } else {
      EXPECT_EQ(got[i], values[i]);
    }
  }
}

TEST(ResampleBilinear, TakesTheNearestWhereANeighbourIsMissing) {
  const Grid from({0, 1}, {0, 1});
  const Raster values{1, 2, 3, kNan};
  const Grid to({0.2, 0.8}, {0.2, 0.8});
  const Raster got = ResampleBilinear(from, values, to);
  EXPECT_EQ(got[0], 1.0f);
  EXPECT_EQ(got[1], 2.0f);
  EXPECT_EQ(got[2], 3.0f);
  EXPECT_TRUE(std::isnan(got[3]));
}

TEST(ResampleBilinear, KnowsNothingOutsideItsEdges) {
  const Grid from({0, 1}, {0, 1});
  const Grid to({-0.6, -0.4, 1.4, 1.6}, {0, 1});
  const Raster got = ResampleBilinear(from, {1, 2, 3, 4}, to);
  EXPECT_TRUE(std::isnan(got[0]));
  EXPECT_EQ(got[1], 1.0f);
  EXPECT_EQ(got[2], 2.0f);
  EXPECT_TRUE(std::isnan(got[3]));
}

TEST(ResampleNearest, IsTheValueOfTheCellThatACentreLiesIn) {
  std::mt19937 random(10);
  std::uniform_real_distribution<float> any(-5, 5);
  const Grid from = UnevenGrid();
  Raster values(from.size());
  for (float& v : values) v = any(random);
  values[9] = kNan;
  std::uniform_real_distribution<double> lon(-98.2, -97.4), lat(20.8, 21.9);
  for (int i = 0; i < 2000; ++i) {
    const LonLat p{lon(random), lat(random)};
    const Grid to({p.lon_deg, p.lon_deg + 1e-9}, {p.lat_deg, p.lat_deg + 1e-9});
    const float got = ResampleNearest(from, values, to)[0];
    const auto cell = from.CellAt(p);
    const float wanted = cell ? values[from.Index(*cell)] : kNan;
    if (std::isnan(wanted)) {
      EXPECT_TRUE(std::isnan(got)) << p.lon_deg << " " << p.lat_deg;
    } else {
      EXPECT_EQ(got, wanted) << p.lon_deg << " " << p.lat_deg;
    }
  }
}

TEST(Resample, IsDoneByItsNameOnly) {
  const Grid from({0, 1}, {0, 1});
  const Grid to({0.25, 0.75}, {0, 1});
  const Raster values{0, 1, 0, 1};
  EXPECT_EQ(Resample(from, values, to, Resampling::kBilinear)[0], 0.25f);
  EXPECT_EQ(Resample(from, values, to, Resampling::kNearest)[0], 0.0f);
  EXPECT_THROW(Resample(from, values, to, Resampling::kNone), std::logic_error);
}

}  // namespace
}  // namespace kg_base
