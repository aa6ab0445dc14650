#include "kg_compiler/traversal/hazard_map.h"

#include <gtest/gtest.h>

#include "kg_base/geo/geodesy.h"
#include "kg_compiler/data_plane/distance_transform.h"
#include "kg_compiler/testing/test_world.h"

namespace kg_compiler {
namespace {

TEST(HazardMap, RisesTowardsClosedCellsAndInSoftZones) {
  const kg_base::Grid grid = EvenGrid(-91, 24, 0.04, 50, 50);
  kg_base::Mask open(grid.size(), 1);
  for (int r = 0; r < 50; ++r) open[r * 50 + 40] = 0;
  kg_base::Raster soft(grid.size(), 1.0f);
  soft[25 * 50 + 5] = 0.3f;
  const HazardMap hazard(grid, open, soft, 10e3);
  for (int c = 26; c < 40; ++c) {
    EXPECT_LT(hazard.At({25, c}), hazard.At({25, c + 1}));
  }
  EXPECT_EQ(1.0, hazard.At({25, 40}));
  EXPECT_FLOAT_EQ(0.7f, hazard.At({25, 5}));
  const double d =
      kg_base::Distance_m(grid.Centre({25, 35}), grid.Centre({25, 40}));
  EXPECT_NEAR(std::exp(-d / 10e3), hazard.At({25, 35}), 1e-4);
}

// Distances of the whole grid at once, against tiles computed in any order.
TEST(HazardMap, EqualsTheFormulaUpToSixRangesAndZeroBeyond) {
  std::mt19937 rng(3);
  int near = 0, beyond = 0;
  for (int round = 0; round < 12; ++round) {
    const kg_base::Grid grid = UnevenGrid(rng, 90, 70);
    const kg_base::Mask open =
        RandomMask(rng, grid.size(), round % 2 ? 0.999 : 0.98);
    const double range_m = Uniform(rng, 500, 8000);
    const kg_base::Raster soft = RandomRaster(rng, grid.size(), 0.9, 1.2);
    const HazardMap hazard(grid, open, soft, range_m);
    kg_base::Mask closed(open.size());
    for (std::size_t i = 0; i < open.size(); ++i) closed[i] = !open[i];
    const std::vector<double> distance_m = DistanceTo_m(grid, closed);
    for (int k = 0; k < 2000; ++k) {
      const kg_base::Cell cell{static_cast<int>(Uniform(rng, 0, 90)),
                               static_cast<int>(Uniform(rng, 0, 70))};
      const std::size_t i = grid.Index(cell);
      const bool far = distance_m[i] >= 6.0 * range_m;
      const double wall = far ? 0.0 : std::exp(-distance_m[i] / range_m);
      const double wanted = std::max(wall, std::max(0.0, 1.0 - soft[i]));
      EXPECT_NEAR(wanted, hazard.At(cell), 1e-6);
      ++(far ? beyond : near);
    }
  }
  EXPECT_GT(near, 1000);
  EXPECT_GT(beyond, 1000);
}

TEST(HazardMap, WithoutRangeIsTheClosedCellsAndTheSoftZones) {
  const kg_base::Grid grid = EvenGrid(-91, 24, 0.04, 5, 5);
  kg_base::Mask open(grid.size(), 1);
  open[12] = 0;
  const HazardMap hazard(grid, open, kg_base::Raster(25, 1.0f), 0.0);
  EXPECT_EQ(1.0, hazard.At({2, 2}));
  EXPECT_EQ(0.0, hazard.At({2, 3}));
  EXPECT_EQ(1.0, hazard.At({5, 3}));  // Off the grid.
  EXPECT_EQ(1.0, hazard.At({2, -1}));
}

}  // namespace
}  // namespace kg_compiler
