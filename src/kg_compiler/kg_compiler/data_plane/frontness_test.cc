#include "kg_compiler/data_plane/frontness.h"

#include <gtest/gtest.h>

#include "kg_compiler/testing/test_world.h"
#include "kg_core/geo/geodesy.h"

namespace kg_compiler {
namespace {

// A plane over kilometres east and north of the grid's corner, with gaps.
kg_core::Raster Plane(const kg_core::Grid& grid, double east, double north) {
  kg_core::Raster values(grid.size());
  const kg_core::LonLat corner = grid.Centre({0, 0});
  for (int r = 0; r < grid.rows(); ++r) {
    for (int c = 0; c < grid.cols(); ++c) {
      const kg_core::LonLat at = grid.Centre({r, c});
      const double y =
          kg_core::Distance_m(corner, {corner.lon_deg, at.lat_deg});
      const double x = kg_core::Distance_m({corner.lon_deg, at.lat_deg}, at);
      values[grid.Index({r, c})] =
          static_cast<float>((east * x + north * y) / 1000.0);
    }
  }
  return values;
}

TEST(Frontness, OfANorthwardRampIsItsSlopeAlsoBesideGaps) {
  std::mt19937 rng(3);
  const kg_core::Grid grid = UnevenGrid(rng, 20, 24);
  kg_core::Raster values = Plane(grid, 0.0, 0.25);
  const kg_core::Mask gaps = RandomMask(rng, grid.size(), 0.15);
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    if (gaps[i]) values[i] = kGap;
  }
  const kg_core::Raster slope = GradientPerKm(grid, values);
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
  const kg_core::Grid grid = UnevenGrid(rng, 6, 6);  // Small: x is not curved.
  const kg_core::Raster slope = GradientPerKm(grid, Plane(grid, 0.3, 0.4));
  for (const float s : slope) EXPECT_NEAR(0.5, s, 3e-3);
}

TEST(Frontness, WeighsRowsOneTwoOneAsSobelDoes) {
  const kg_core::Grid grid = EvenGrid(0, -0.04, 0.04, 3, 3);
  // Only the middle row slopes: 2 of the 4 weights.
  const kg_core::Raster values = {0, 0, 0, 0, 1, 2, 0, 0, 0};
  const double km = kg_core::Distance_m({0, 0}, {0.04, 0}) / 1000.0;
  // Northward: columns' differences are 0 - 0 over two steps.
  EXPECT_NEAR(0.5 / km, GradientPerKm(grid, values)[4], 1e-6);
}

TEST(Frontness, OfALonelyCellIsZero) {
  const kg_core::Grid grid = EvenGrid(0, 0, 1, 3, 3);
  kg_core::Raster values(9, kGap);
  values[4] = 5.0f;
  EXPECT_EQ(0.0f, GradientPerKm(grid, values)[4]);
  EXPECT_TRUE(std::isnan(GradientPerKm(grid, values)[0]));
}

}  // namespace
}  // namespace kg_compiler
