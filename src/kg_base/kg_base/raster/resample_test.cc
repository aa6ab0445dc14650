#include "kg_base/raster/resample.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

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

// Reference: all pairs of cells.
Raster TouchedByPairs(const Grid& from, const Raster& values, const Grid& to) {
  Raster result(to.size(), kNan);
  const auto overlap = [](const Axis& a, int i, const Axis& b, int j) {
    return std::min(a.Edge(i + 1), b.Edge(j + 1)) -
               std::max(a.Edge(i), b.Edge(j)) >
           0.01 *
               std::min(a.Edge(i + 1) - a.Edge(i), b.Edge(j + 1) - b.Edge(j));
  };
  for (int r = 0; r < from.rows(); ++r) {
    for (int c = 0; c < from.cols(); ++c) {
      for (int row = 0; row < to.rows(); ++row) {
        for (int col = 0; col < to.cols(); ++col) {
          if (!overlap(from.lat_axis(), r, to.lat_axis(), row)) continue;
          if (!overlap(from.lon_axis(), c, to.lon_axis(), col)) continue;
          const float value = values[from.Index({r, c})];
          float& cell = result[to.Index({row, col})];
          if (std::isnan(cell) || std::abs(value) > std::abs(cell)) {
            cell = std::isnan(value) ? cell : value;
          }
        }
      }
    }
  }
  return result;
}

std::vector<double> RandomAxis(std::mt19937& random, double first, int size) {
  std::uniform_real_distribution<double> step(0.01, 0.3);
  std::vector<double> axis(1, first);
  while (static_cast<int>(axis.size()) < size) {
    axis.push_back(axis.back() + step(random));
  }
  return axis;
}

TEST(ResampleTouched, LosesNoCellOfAnyGridAndAddsNone) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-2, 2);
  std::uniform_int_distribution<int> size(2, 40);
  for (int trial = 0; trial < 200; ++trial) {
    const auto grid = [&] {
      return Grid(RandomAxis(random, place(random), size(random)),
                  RandomAxis(random, place(random), size(random)));
    };
    const Grid from = grid();
    const Grid to = grid();
    Raster values(from.size(), 0.0f);
    for (float& value : values) {
      const double kind = place(random);
      value = kind > 1.8 ? 1.0f : kind < -1.5 ? kNan : 0.0f;
    }
    const Raster got = ResampleTouched(from, values, to);
    const Raster expected = TouchedByPairs(from, values, to);
    for (std::size_t i = 0; i < to.size(); ++i) {
      if (std::isnan(expected[i])) {
        EXPECT_TRUE(std::isnan(got[i])) << trial << " " << i;
      } else {
        EXPECT_EQ(got[i], expected[i]) << trial << " " << i;
      }
    }
  }
}

// Cells of a fifth of the size: a wall of one cell closes the column that it
// lies in, and no neighbour, though its edge may be theirs.
TEST(ResampleTouched, AFineWallClosesTheCellsThatItIsIn) {
  std::vector<double> fine, coarse;
  for (int i = 0; i < 50; ++i) fine.push_back(0.1 * i + 0.05);
  for (int i = 0; i < 10; ++i) coarse.push_back(0.5 * i + 0.25);
  const Grid from(fine, fine);
  const Grid to(coarse, coarse);
  for (int wall = 0; wall < 50; ++wall) {
    Raster values(from.size(), 0.0f);
    for (int row = 10; row < 40; ++row) values[from.Index({row, wall})] = 1.0f;
    const Raster got = ResampleTouched(from, values, to);
    for (int row = 0; row < 10; ++row) {
      for (int col = 0; col < 10; ++col) {
        const bool inside = col == wall / 5 && row >= 2 && row < 8;
        EXPECT_EQ(got[to.Index({row, col})], inside ? 1.0f : 0.0f)
            << wall << ": " << row << " " << col;
      }
    }
  }
}

}  // namespace
}  // namespace kg_base
