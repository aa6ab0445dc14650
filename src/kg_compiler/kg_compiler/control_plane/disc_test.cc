#include "kg_compiler/control_plane/disc.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "kg_base/geo/geodesy.h"
#include "kg_compiler/testing/test_world.h"

namespace kg_compiler {
namespace {

TEST(MeridianArc, IsTheGeodesicAlongAMeridian) {
  for (double lat = -90.0; lat <= 90.0; lat += 7.5) {
    const double wanted_m = kg_base::Distance_m({10.0, 0.0}, {10.0, lat});
    EXPECT_NEAR(std::copysign(wanted_m, lat), MeridianArc_m(lat), 1e-6) << lat;
  }
}

// Definition of a disc, evaluated for one cell.
bool Sees(const kg_base::Grid& grid, kg_base::Cell a, kg_base::Cell b,
          double radius_m) {
  const double north_m = MeridianArc_m(grid.lat_deg()[b.row]) -
                         MeridianArc_m(grid.lat_deg()[a.row]);
  const double east_m =
      std::abs(grid.lon_deg()[b.col] - grid.lon_deg()[a.col]) *
      (1.0 / kg_base::LocalScale(grid.lat_deg()[b.row]).lon_deg);
  return east_m * east_m <= radius_m * radius_m - north_m * north_m;
}

void ExpectDisc(const kg_base::Grid& grid, const Discs& discs,
                kg_base::Cell centre) {
  const Span rows = discs.Rows(centre.row);
  std::vector<Span> by_column;
  for (int row = 0; row < grid.rows(); ++row) {
    Span seen;
    if (rows.Has(row)) {
      seen = discs.Columns(centre, row);
      discs.Columns(centre.row, {0, grid.cols()}, row, &by_column);
      EXPECT_EQ(seen.first, by_column[centre.col].first);
      EXPECT_EQ(seen.last, by_column[centre.col].last);
    }
    for (int col = 0; col < grid.cols(); ++col) {
      EXPECT_EQ(Sees(grid, centre, {row, col}, discs.radius_m()), seen.Has(col))
          << row << ' ' << col;
    }
  }
}

TEST(Discs, HoldTheCellsWithinTheirRadius) {
  std::mt19937 rng(41);
  for (int round = 0; round < 200; ++round) {
    const kg_base::Grid grid = UnevenGrid(rng, 17, 19);
    const int first = static_cast<int>(rng() % 17);
    const Span rows{first, first + 1 + static_cast<int>(rng() % (17 - first))};
    const Discs discs(grid, Uniform(rng, 0, 40e3), rows);
    const int row = rows.first + static_cast<int>(rng() % rows.size());
    ExpectDisc(grid, discs, {row, static_cast<int>(rng() % 19)});
  }
}

TEST(Discs, ReachOverTheWholeGridAndNoFarther) {
  const kg_base::Grid grid = EvenGrid(-90, 25, 0.04, 5, 7);
  const Discs all(grid, 1e7, {2, 3});
  EXPECT_EQ(5, all.Rows(2).size());
  EXPECT_EQ(7, all.Columns({2, 3}, 0).size());
  const Discs point(grid, 0.0, {2, 3});
  EXPECT_EQ(1, point.Rows(2).size());
  EXPECT_EQ(1, point.Columns({2, 3}, 2).size());
}

TEST(Discs, RefuseARadiusThatIsNone) {
  const kg_base::Grid grid = EvenGrid(-90, 25, 0.04, 5, 7);
  EXPECT_THROW(Discs(grid, -1.0, {0, 5}), std::logic_error);
  EXPECT_THROW(Discs(grid, kGap, {0, 5}), std::logic_error);
}

TEST(EvenColumns, HaveAHalfWidthOrNullopt) {
  std::mt19937 rng(42);
  int known = 0;
  for (int round = 0; round < 300; ++round) {
    std::vector<double> lon = EvenAxis(-98, 0.04, 50);
    const double noise = round % 3 == 0 ? 0.0 : Uniform(rng, 0, 4e-3);
    for (double& x : lon) x += Uniform(rng, -noise, noise);
    const kg_base::Grid grid(lon, EvenAxis(0, 0.1, 2));
    const double reach_deg = Uniform(rng, 0, 2.5);
    const std::optional<int> width = EvenColumns(grid).HalfWidth(reach_deg);
    if (!width) continue;
    ++known;
    for (int a = 0; a < 50; ++a) {
      for (int b = 0; b < 50; ++b) {
        EXPECT_EQ(std::abs(lon[a] - lon[b]) <= reach_deg,
                  std::abs(a - b) <= *width);
      }
    }
  }
  EXPECT_GT(known, 150);
}

TEST(EvenColumns, LeaveAReachThatEndsAtACentreToOthers) {
  const EvenColumns columns(EvenGrid(-98, 25, 0.25, 2, 50));
  EXPECT_FALSE(columns.HalfWidth(0.75));
  EXPECT_EQ(2, columns.HalfWidth(0.74));
  EXPECT_EQ(0, columns.HalfWidth(0.0));
  EXPECT_EQ(50, columns.HalfWidth(1e9));
}

}  // namespace
}  // namespace kg_compiler
