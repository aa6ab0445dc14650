#include "kg_base/raster/outliers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace kg_base {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

Grid SquareGrid(int size) {
  std::vector<double> centres;
  for (int i = 0; i < size; ++i) centres.push_back(0.1 * i);
  return Grid(centres, centres);
}

// A smooth eddy whose core is far from the median of all values.
Raster Eddy(int size) {
  Raster raster;
  for (int row = 0; row < size; ++row) {
    for (int col = 0; col < size; ++col) {
      const double x = (row - size / 3) / 6.0;
      const double y = (col - size / 3) / 6.0;
      raster.push_back(static_cast<float>(2.0 * std::exp(-x * x - y * y) +
                                          0.01 * std::sin(0.7 * row + col)));
    }
  }
  return raster;
}

TEST(FindOutliers, LeavesStrongSmoothCurrentsAlone) {
  EXPECT_EQ(FindOutliers(SquareGrid(60), {Eddy(60), Eddy(60)}).count, 0u);
}

TEST(FindOutliers, FindsSpikesOfSingleCells) {
  const Grid grid = SquareGrid(60);
  std::vector<Raster> rasters = {Eddy(60), Eddy(60)};
  rasters[1][grid.Index({50, 40})] = -3.0f;
  rasters[1][grid.Index({50, 50})] = 3.0f;
  const OutlierValues found = FindOutliers(grid, rasters);
  EXPECT_EQ(found.count, 2u);
  EXPECT_EQ(found.raster, 1u);
  EXPECT_EQ(found.cell, (Cell{50, 40}));
  EXPECT_EQ(found.value, -3.0f);
}

TEST(FindOutliers, LooksAtCellsOnEdgesAndBesideNoData) {
  const Grid grid = SquareGrid(60);
  std::vector<Raster> rasters = {Eddy(60)};
  rasters[0][grid.Index({59, 59})] = 5.0f;
  rasters[0][grid.Index({40, 40})] = 5.0f;
  rasters[0][grid.Index({40, 41})] = kNan;
  EXPECT_EQ(FindOutliers(grid, rasters).count, 2u);
}

TEST(FindOutliers, CountsNoneWhereMostValuesAreEqualOrMissing) {
  const Grid grid = SquareGrid(10);
  Raster still(100, 0.0f);
  still[55] = 1.0f;
  EXPECT_EQ(FindOutliers(grid, {still}).count, 0u);
  EXPECT_EQ(FindOutliers(grid, {Raster(100, kNan)}).count, 0u);
  EXPECT_EQ(FindOutliers(grid, {}).count, 0u);
}

}  // namespace
}  // namespace kg_base
