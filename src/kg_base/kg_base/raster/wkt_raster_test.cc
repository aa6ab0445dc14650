// Rasterisation of geometries against GEOS, cell by cell.

#include "kg_base/raster/wkt_raster.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "kg_base/geo/geos.h"
#include "kg_base/geo/wkt.h"

namespace kg_base {
namespace {

std::string Box(double west, double south, double east, double north) {
  const auto vertex = [](double lon, double lat) {
    const std::string point = PointWkt({lon, lat});
    return point.substr(6, point.size() - 7);
  };
  return "POLYGON((" + vertex(west, south) + "," + vertex(east, south) + "," +
         vertex(east, north) + "," + vertex(west, north) + "," +
         vertex(west, south) + "))";
}

Geometry CellBox(const Grid& grid, int row, int col) {
  const Axis& lon = grid.lon_axis();
  const Axis& lat = grid.lat_axis();
  return Geometry::FromWkt(
      Box(lon.Edge(col), lat.Edge(row), lon.Edge(col + 1), lat.Edge(row + 1)));
}

Mask TouchedByBruteForce(const Geometry& area, const Grid& grid) {
  Mask mask;
  for (int row = 0; row < grid.rows(); ++row) {
    for (int col = 0; col < grid.cols(); ++col) {
      mask.push_back(area.Intersects(CellBox(grid, row, col)));
    }
  }
  return mask;
}

// Expects all touched cells, and otherwise only cells within rounding of them.
void ExpectSafeSupercover(const Geometry& area, const Grid& grid) {
  const Mask got = RasteriseTouched(area, grid);
  const Mask touched = TouchedByBruteForce(area, grid);
  for (std::size_t i = 0; i < got.size(); ++i) {
    ASSERT_GE(got[i], touched[i]) << area.Wkt();
    if (got[i] == touched[i]) continue;
    const int cols = grid.cols();
    const Geometry cell = CellBox(grid, i / cols, i % cols);
    ASSERT_LT(area.DistanceDegrees(cell), 1e-10) << area.Wkt();
  }
}

Mask CentresByBruteForce(const Geometry& area, const Grid& grid) {
  Mask mask;
  for (int row = 0; row < grid.rows(); ++row) {
    for (int col = 0; col < grid.cols(); ++col) {
      mask.push_back(area.Intersects(
          Geometry::FromWkt(PointWkt(grid.Centre({row, col})))));
    }
  }
  return mask;
}

std::vector<double> UnevenAxis(std::mt19937* random, int size) {
  std::uniform_real_distribution<double> step(0.1, 1.5);
  std::vector<double> axis{-10.0};
  while (static_cast<int>(axis.size()) < size) {
    axis.push_back(axis.back() + step(*random));
  }
  return axis;
}

// Random, often invalid polygons of one to three members, extending beyond the
// grid.
std::string RandomArea(std::mt19937* random) {
  std::uniform_real_distribution<double> at(-12, 10), size(0.05, 12);
  std::string text = "MULTIPOLYGON(";
  for (unsigned members = 1 + (*random)() % 3; members > 0; --members) {
    const LonLat middle{at(*random), at(*random)};
    const double reach = size(*random);
    std::uniform_real_distribution<double> off(-reach, reach);
    std::string first;
    text += "((";
    for (unsigned n = 3 + (*random)() % 9; n > 0; --n) {
      const std::string point = PointWkt(
          {middle.lon_deg + off(*random), middle.lat_deg + off(*random)});
      const std::string vertex = point.substr(6, point.size() - 7);
      if (first.empty()) first = vertex;
      text += vertex + ",";
    }
    text += first + (members > 1 ? "))," : "))");
  }
  return text + ")";
}

TEST(RasteriseTouched, IsTheSupercoverOnRandomAreasAndUnevenGrids) {
  std::mt19937 random(21);
  std::size_t touched = 0;
  for (int i = 0; i < 80; ++i) {
    const Grid grid(UnevenAxis(&random, 23), UnevenAxis(&random, 19));
    const Geometry area = Geometry::FromWkt(RandomArea(&random));
    const Mask got = RasteriseTouched(area, grid);
    ASSERT_EQ(got, TouchedByBruteForce(area, grid)) << area.Wkt();
    touched += std::count(got.begin(), got.end(), 1);
  }
  EXPECT_GT(touched, 1000u);
}

TEST(RasteriseCentres, AgreesWithGeosOnRandomAreasAndUnevenGrids) {
  std::mt19937 random(22);
  std::size_t inside = 0;
  for (int i = 0; i < 60; ++i) {
    const Grid grid(UnevenAxis(&random, 41), UnevenAxis(&random, 37));
    const Geometry area = Geometry::FromWkt(RandomArea(&random));
    const Mask got = RasteriseCentres(area, grid);
    ASSERT_EQ(got, CentresByBruteForce(area, grid)) << area.Wkt();
    inside += std::count(got.begin(), got.end(), 1);
  }
  EXPECT_GT(inside, 1000u);
}

// Integer coordinates: vertices on centres, edges along centres, edges through
// cell corners.
TEST(Rasterise, AgreesWithGeosWhereVerticesLieOnCentresAndCorners) {
  std::mt19937 random(23);
  std::vector<double> axis;
  for (int i = 0; i <= 16; ++i) axis.push_back(i);
  const Grid grid(axis, axis);
  for (int i = 0; i < 100; ++i) {
    const double half = i % 2 == 0 ? 0.0 : 0.5;
    std::string text = "POLYGON((", first;
    for (unsigned n = 3 + random() % 5; n > 0; --n) {
      const std::string vertex = std::to_string(random() % 18 - 1.0 + half) +
                                 " " +
                                 std::to_string(random() % 18 - 1.0 + half);
      if (first.empty()) first = vertex;
      text += vertex + ",";
    }
    try {
      const Geometry area = Geometry::FromWkt(text + first + "))");
      ASSERT_EQ(RasteriseCentres(area, grid), CentresByBruteForce(area, grid));
      ExpectSafeSupercover(area, grid);
    } catch (const std::runtime_error&) {
      continue;  // No area.
    }
  }
}

TEST(Rasterise, ASpeckInsideOneCellTouchesThatCellOnly) {
  const Grid grid({0, 1, 2}, {0, 1, 2});
  const Geometry speck = Geometry::FromWkt(Box(1.2, 0.8, 1.21, 0.81));
  const Mask touched = RasteriseTouched(speck, grid);
  EXPECT_EQ(std::count(touched.begin(), touched.end(), 1), 1);
  EXPECT_EQ(touched[grid.Index({1, 1})], 1);
  const Mask centres = RasteriseCentres(speck, grid);
  EXPECT_EQ(std::count(centres.begin(), centres.end(), 1), 0);
}

TEST(Rasterise, AnAreaOutsideTouchesNothingAndOneAroundTouchesAll) {
  const Grid grid({0, 1, 2}, {0, 1, 2});
  const Mask none = RasteriseTouched(Geometry::FromWkt(Box(5, 5, 6, 6)), grid);
  EXPECT_EQ(std::count(none.begin(), none.end(), 1), 0);
  const Mask all =
      RasteriseTouched(Geometry::FromWkt(Box(-50, -50, 50, 50)), grid);
  EXPECT_EQ(std::count(all.begin(), all.end(), 1), 9);
}

TEST(Rasterise, SharedEdgesOfCellsTouchBothCells) {
  const Grid grid({0, 1, 2}, {0, 1, 2});
  const Mask touched =
      RasteriseTouched(Geometry::FromWkt(Box(0.5, 0.5, 1.5, 1.5)), grid);
  EXPECT_EQ(std::count(touched.begin(), touched.end(), 1), 9);
}

TEST(Rasterise, LinesAndPointsTouchCellsButHoldNoCentres) {
  const Grid grid({0, 1, 2}, {0, 1, 2});
  const Geometry both = Geometry::FromWkt(
      "GEOMETRYCOLLECTION(POINT(2 0), LINESTRING(0 0.2, 0.2 2))");
  const Mask touched = RasteriseTouched(both, grid);
  EXPECT_EQ(touched, (Mask{1, 0, 1, 1, 0, 0, 1, 0, 0}));
  EXPECT_EQ(RasteriseCentres(both, grid), Mask(9, 0));
}

TEST(Rasterise, OverlappingMembersOfACollectionAreAllInside) {
  const Grid grid({0, 1, 2}, {0, 1, 2});
  const Geometry both =
      Geometry::FromWkt("GEOMETRYCOLLECTION(" + Box(-0.2, -0.2, 1.2, 1.2) +
                        "," + Box(0.8, 0.8, 2.2, 2.2) + ")");
  EXPECT_EQ(RasteriseCentres(both, grid), (Mask{1, 1, 0, 1, 1, 1, 0, 1, 1}));
}

}  // namespace
}  // namespace kg_base
