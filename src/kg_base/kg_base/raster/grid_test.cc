#include "kg_base/raster/grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

#include "kg_base/geo/geodesy.h"

namespace kg_base {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

Grid UnevenGrid() {
  return Grid({-98, -97.9, -97.7, -97.6}, {21, 21.1, 21.3, 21.6, 21.7});
}

TEST(Grid, IndexesRowByRowFromTheSouthWest) {
  const Grid grid = UnevenGrid();
  EXPECT_EQ(grid.rows(), 5);
  EXPECT_EQ(grid.cols(), 4);
  EXPECT_EQ(grid.size(), 20u);
  EXPECT_EQ(grid.Index({2, 3}), 11u);
  EXPECT_EQ(grid.Centre({2, 3}), (LonLat{-97.6, 21.3}));
  EXPECT_EQ(grid.Text(), "5 x 4 cells, -98.05 to -97.55 E, 20.95 to 21.75 N");
  EXPECT_TRUE(grid.Contains({4, 3}));
  EXPECT_FALSE(grid.Contains({5, 3}));
  EXPECT_FALSE(grid.Contains({0, -1}));
}

TEST(Grid, RefusesAxesThatDoNotAscend) {
  EXPECT_THROW(Grid({0, 1}, {1, 0}), std::logic_error);
  EXPECT_THROW(Grid({0}, {0, 1}), std::logic_error);
}

TEST(Grid, LocateAndPositionAreInverse) {
  const Grid grid = UnevenGrid();
  std::mt19937 random(5);
  std::uniform_real_distribution<double> lon(grid.west_deg(), grid.east_deg());
  std::uniform_real_distribution<double> lat(grid.south_deg(),
                                             grid.north_deg());
  for (int i = 0; i < 1000; ++i) {
    const LonLat position{lon(random), lat(random)};
    const auto point = grid.Locate(position);
    ASSERT_TRUE(point);
    EXPECT_NEAR(grid.Position(*point).lon_deg, position.lon_deg, 1e-11);
    EXPECT_NEAR(grid.Position(*point).lat_deg, position.lat_deg, 1e-11);
  }
}

TEST(Grid, CellAtIsTheCellWhoseEdgesSurroundThePosition) {
  const Grid grid = UnevenGrid();
  std::mt19937 random(6);
  std::uniform_real_distribution<double> lon(-98.2, -97.4);
  std::uniform_real_distribution<double> lat(20.8, 21.9);
  for (int i = 0; i < 2000; ++i) {
    const LonLat p{lon(random), lat(random)};
    const auto cell = grid.CellAt(p);
    const bool inside =
        p.lon_deg >= grid.west_deg() && p.lon_deg <= grid.east_deg() &&
        p.lat_deg >= grid.south_deg() && p.lat_deg <= grid.north_deg();
    ASSERT_EQ(cell.has_value(), inside);
    if (!cell) continue;
    EXPECT_GE(p.lon_deg, grid.lon_axis().Edge(cell->col) - 1e-12);
    EXPECT_LE(p.lon_deg, grid.lon_axis().Edge(cell->col + 1) + 1e-12);
    EXPECT_GE(p.lat_deg, grid.lat_axis().Edge(cell->row) - 1e-12);
    EXPECT_LE(p.lat_deg, grid.lat_axis().Edge(cell->row + 1) + 1e-12);
  }
}

TEST(Grid, TheOuterEdgeBelongsToTheOuterCell) {
  const Grid grid({0, 1, 2}, {0, 1});
  EXPECT_EQ(*grid.CellAt({2.5, 1.5}), (Cell{1, 2}));
  EXPECT_EQ(*grid.CellAt({-0.5, -0.5}), (Cell{0, 0}));
  EXPECT_FALSE(grid.CellAt({2.5000001, 0}));
  EXPECT_FALSE(grid.CellAt({kNan, 0}));
  EXPECT_FALSE(grid.CellAt({0, kNan}));
}

TEST(Grid, MetresPerStepAreGeodesicsBetweenNeighbours) {
  const Grid grid = UnevenGrid();
  for (int row = 0; row + 1 < grid.rows(); ++row) {
    const double expected =
        Distance_m({-97, grid.lat_deg()[row]}, {-97, grid.lat_deg()[row + 1]});
    EXPECT_NEAR(grid.MetresPerRow(row + 0.5) / expected, 1.0, 1e-6);
  }
  for (int col = 0; col + 1 < grid.cols(); ++col) {
    const double expected = Distance_m({grid.lon_deg()[col], 21.3},
                                       {grid.lon_deg()[col + 1], 21.3});
    EXPECT_NEAR(grid.MetresPerCol(2, col + 0.5) / expected, 1.0, 1e-6);
  }
}

TEST(Grid, MiddleIsTheMiddleOfTheEdges) {
  const Grid grid({0, 1, 3}, {0, 2});
  EXPECT_EQ(grid.Middle(), (LonLat{1.75, 1.0}));
}

TEST(Grid, HashTellsGridsApartAndTheSameGridTogether) {
  EXPECT_EQ(UnevenGrid().Hash(), UnevenGrid().Hash());
  EXPECT_EQ(UnevenGrid().Hash().size(), 64u);
  EXPECT_NE(Grid({0, 1, 2}, {3, 4}).Hash(), Grid({0, 1}, {2, 3, 4}).Hash());
  EXPECT_NE(Grid({0, 1}, {2, 3}).Hash(), Grid({2, 3}, {0, 1}).Hash());
}

TEST(Grid, AlmostEqualsForgivesFloatNoiseOnly) {
  std::vector<double> lon, lon_float, lat{21, 21.04};
  for (int i = 0; i < 51; ++i) {
    lon.push_back(-98 + 0.04 * i);
    lon_float.push_back(static_cast<float>(lon.back()));
  }
  const Grid grid(lon, lat);
  EXPECT_NE(grid, Grid(lon_float, lat));
  EXPECT_TRUE(grid.AlmostEquals(Grid(lon_float, lat)));
  EXPECT_FALSE(grid.AlmostEquals(Grid(lon_float, lat), 1e-9));
  EXPECT_FALSE(grid.AlmostEquals(Grid(lon, {21, 21.05})));
  EXPECT_FALSE(grid.AlmostEquals(Grid(lon, {21, 21.04, 21.08})));
}

TEST(Grid, ExtendedKeepsItsCellsAndGoesOnAtTheOuterSpacing) {
  const Grid grid({1.0, 2.0, 4.0}, {10.0, 10.5});
  const Grid more = grid.Extended(2);
  EXPECT_EQ(more.lon_deg(),
            (std::vector<double>{-1.0, 0.0, 1.0, 2.0, 4.0, 6.0, 8.0}));
  EXPECT_EQ(more.lat_deg(),
            (std::vector<double>{9.0, 9.5, 10.0, 10.5, 11.0, 11.5}));
  EXPECT_EQ(grid.Extended(0), grid);
}

}  // namespace
}  // namespace kg_base
