#include "kg_compiler/data_plane/frontness.h"

#include <gtest/gtest.h>

#include "kg_base/geo/geodesy.h"
#include "kg_compiler/testing/test_world.h"

namespace kg_compiler {
namespace {

// A plane over kilometres east and north of the grid's corner, with gaps.
kg_base::Raster Plane(const kg_base::Grid& grid, double east, double north) {
  kg_base::Raster values(grid.size());
  const kg_base::LonLat corner = grid.Centre({0, 0});
  for (int r = 0; r < grid.rows(); ++r) {
    for (int c = 0; c < grid.cols(); ++c) {
      const kg_base::LonLat at = grid.Centre({r, c});
      const double y =
          kg_base::Distance_m(corner, {corner.lon_deg, at.lat_deg});
      const double x = kg_base::Distance_m({corner.lon_deg, at.lat_deg}, at);
      values[grid.Index({r, c})] =
          static_cast<float>((east * x + north * y) / 1000.0);
    }
  }
  return values;
}

TEST(Frontness, OfANorthwardRampIsItsSlopeAlsoBesideGaps) {
  std::mt19937 rng(3);
  const kg_base::Grid grid = UnevenGrid(rng, 20, 24);
  kg_base::Raster values = Plane(grid, 0.0, 0.25);
  const kg_base::Mask gaps = RandomMask(rng, grid.size(), 0.15);
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    if (gaps[i]) values[i] = kGap;
  }
  const kg_base::Raster slope = GradientPerKm(grid, values);
  int checked = 0;
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    EXPECT_EQ(gaps[i] == 1, std::isnan(slope[i]));
    if (gaps[i] || slope[i] == 0.0f) continue;
    EXPECT_NEAR(0.25, slope[i], 1e-3);
    ++checked;
  }
  EXPECT_GT(checked, 300);
}

TEST(Frontness, OfAnObliqueRampJoinsBothComponents) {
  std::mt19937 rng(4);
  // Small: x is nearly linear.
  const kg_base::Grid grid = UnevenGrid(rng, 6, 6);
  const kg_base::Raster slope = GradientPerKm(grid, Plane(grid, 0.3, 0.4));
  for (const float s : slope) EXPECT_NEAR(0.5, s, 3e-3);
}

TEST(Frontness, WeighsRowsOneTwoOneAsSobelDoes) {
  const kg_base::Grid grid = EvenGrid(0, -0.04, 0.04, 3, 3);
  // Only the middle row slopes: 2 of the 4 weights.
  const kg_base::Raster values = {0, 0, 0, 0, 1, 2, 0, 0, 0};
  const double km = kg_base::Distance_m({0, 0}, {0.04, 0}) / 1000.0;
  // Northward: columns' differences are 0 - 0 over two steps.
  EXPECT_NEAR(0.5 / km, GradientPerKm(grid, values)[4], 1e-6);
}

TEST(Frontness, OfALonelyCellIsZero) {
  const kg_base::Grid grid = EvenGrid(0, 0, 1, 3, 3);
  kg_base::Raster values(9, kGap);
  values[4] = 5.0f;
  EXPECT_EQ(0.0f, GradientPerKm(grid, values)[4]);
  EXPECT_TRUE(std::isnan(GradientPerKm(grid, values)[0]));
}

}  // namespace
}  // namespace kg_compiler
