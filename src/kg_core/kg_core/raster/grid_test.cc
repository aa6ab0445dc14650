#include "kg_core/raster/grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "kg_core/geo/geodesy.h"

namespace kg_core {
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

TEST(Grid, IndexesRowByRowFromTheSouthWest) {
  const Grid grid = UnevenGrid();
  EXPECT_EQ(grid.rows(), 5);
  EXPECT_EQ(grid.cols(), 4);
  EXPECT_EQ(grid.size(), 20u);
  EXPECT_EQ(grid.Index({2, 3}), 11u);
  EXPECT_EQ(grid.Centre({2, 3}), (LonLat{-97.6, 21.3}));
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

}  // namespace
}  // namespace kg_core
