#include "kg_compiler/control_plane/proximal_recurrence.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "kg_base/geo/geodesy.h"
#include "kg_compiler/control_plane/disc.h"
#include "kg_compiler/testing/test_world.h"

namespace kg_compiler {
namespace {

// Indices of the cells within `reach_m` of each cell.
std::vector<std::vector<int>> AllDiscs(const kg_base::Grid& grid,
                                       double reach_m) {
  std::vector<double> north_m, m_per_deg;  // Per row.
  for (const double lat_deg : grid.lat_deg()) {
    north_m.push_back(MeridianArc_m(lat_deg));
    m_per_deg.push_back(1.0 / kg_base::LocalScale(lat_deg).lon_deg);
  }
  const int size = static_cast<int>(grid.size());
  std::vector<std::vector<int>> discs(size);
  for (int i = 0; i < size; ++i) {
    for (int j = 0; j < size; ++j) {
      const int from = i / grid.cols(), to = j / grid.cols();
      const double north = north_m[to] - north_m[from];
      const double east = std::abs(grid.lon_deg()[j % grid.cols()] -
                                   grid.lon_deg()[i % grid.cols()]) *
                          m_per_deg[to];
      if (east * east + north * north <= reach_m * reach_m) {
        discs[i].push_back(j);
      }
    }
  }
  return discs;
}

// Reference: every disc summed from scratch, cell by cell, for every pick.
std::vector<RecurrencePick> Naive(const kg_base::Grid& grid,
                                  kg_base::Raster utility,
                                  kg_base::Mask allowed,
                                  const RecurrenceOptions& options) {
  std::vector<RecurrencePick> picks;
  const int size = static_cast<int>(grid.size());
  const auto footprints = AllDiscs(grid, options.radius_m);
  const auto spacings = AllDiscs(grid, options.spacing_m);
  for (int k = 0; k < options.count; ++k) {
    double most = 0.0;
    int best = -1;
    for (int i = 0; i < size; ++i) {
      if (!allowed[i]) continue;
      double sum = 0.0;
      for (const int j : footprints[i]) sum += utility[j];
      if (sum > most) best = i, most = sum;
    }
    if (best < 0) break;
    picks.push_back({{best / grid.cols(), best % grid.cols()}, most, {}});
    for (const int j : footprints[best]) {
      if (utility[j] > 0.0f) picks.back().footprint.push_back(j);
    }
    for (const int j : spacings[best]) {
      utility[j] = 0.0f;
      allowed[j] = 0;
    }
  }
  return picks;
}

void ExpectSamePicks(const std::vector<RecurrencePick>& wanted,
                     const std::vector<RecurrencePick>& got) {
  ASSERT_EQ(wanted.size(), got.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    EXPECT_TRUE(wanted[i].cell == got[i].cell) << "pick " << i;
    EXPECT_NEAR(wanted[i].score, got[i].score, 1e-6);
    EXPECT_EQ(wanted[i].footprint, got[i].footprint) << "pick " << i;
  }
}

TEST(ProximalRecurrence, PicksWhatTheNaiveLoopPicks) {
  std::mt19937 rng(21);
  for (int round = 0; round < 15; ++round) {
    const kg_base::Grid grid = UnevenGrid(rng, 21, 26);
    kg_base::Raster utility = RandomRaster(rng, grid.size(), 0, 1);
    const kg_base::Mask land = RandomMask(rng, grid.size(), 0.2);
    for (std::size_t i = 0; i < land.size(); ++i) {
      if (land[i]) utility[i] = 0.0f;
    }
    const RecurrenceOptions options = {Uniform(rng, 0, 30e3),
                                       Uniform(rng, 0, 30e3), 12};
    const kg_base::Mask allowed = RandomMask(rng, grid.size(), 0.7);
    ExpectSamePicks(Naive(grid, utility, allowed, options),
                    ProximalRecurrence(grid, utility, allowed, options));
  }
}

// Evenly spaced columns, as in files: half widths are precomputed, and the grid
// needs two strips.
TEST(ProximalRecurrence, PicksWhatTheNaiveLoopPicksOnWideGrids) {
  std::mt19937 rng(23);
  for (int round = 0; round < 8; ++round) {
    std::vector<double> lon = EvenAxis(-98, 0.04, 150), lat(1, 40.0);
    for (double& x : lon) x += Uniform(rng, -2e-6, 2e-6);
    while (lat.size() < 8) lat.push_back(lat.back() + Uniform(rng, .02, .05));
    const kg_base::Grid grid(lon, lat);
    kg_base::Raster utility = RandomRaster(rng, grid.size(), 0, 1);
    const kg_base::Mask worthless = RandomMask(rng, grid.size(), 0.1 * round);
    for (std::size_t i = 0; i < utility.size(); ++i) {
      if (worthless[i]) utility[i] = 0.0f;
    }
    kg_base::Mask allowed = RandomMask(rng, grid.size(), 0.8);
    for (int row = 0; row < 4; ++row) {  // Nothing in a corner.
      std::fill_n(&allowed[grid.Index({row, 0})], 10 * round, 0);
    }
    const RecurrenceOptions options = {Uniform(rng, 0, 20e3),
                                       Uniform(rng, 0, 40e3), 20};
    ExpectSamePicks(Naive(grid, utility, allowed, options),
                    ProximalRecurrence(grid, utility, allowed, options));
  }
}

// Scattered allowed cells, as within the reach of several places.
TEST(ProximalRecurrence, PicksWhatTheNaiveLoopPicksAmongScatteredCells) {
  std::mt19937 rng(25);
  const kg_base::Grid grid = EvenGrid(-98, 25, 0.04, 7, 200);
  for (int round = 0; round < 12; ++round) {
    const kg_base::Raster utility = RandomRaster(rng, grid.size(), 0, 1);
    kg_base::Mask allowed(grid.size(), 0);
    for (int patch = 0; patch < 4; ++patch) {
      const int row = static_cast<int>(rng() % 5);
      const int col = static_cast<int>(rng() % 190);
      for (int i = 0; i < 20; ++i) {
        allowed[grid.Index({row + i % 3, col + i % 7})] = rng() % 2;
      }
    }
    const RecurrenceOptions options = {Uniform(rng, 0, 30e3),
                                       Uniform(rng, 0, 20e3), 20};
    ExpectSamePicks(Naive(grid, utility, allowed, options),
                    ProximalRecurrence(grid, utility, allowed, options));
  }
}

TEST(ProximalRecurrence, ReadsNothingBeyondTheDiscsOfAllowedCells) {
  std::mt19937 rng(24);
  const kg_base::Grid grid = EvenGrid(-90, 25, 0.04, 30, 40);
  kg_base::Raster utility = RandomRaster(rng, grid.size(), 0, 1);
  kg_base::Mask allowed(grid.size(), 0);
  for (int row = 12; row < 16; ++row) {
    for (int col = 15; col < 21; ++col) allowed[grid.Index({row, col})] = 1;
  }
  const RecurrenceOptions options = {9000, 5000, 10};  // Two cells' radius.
  const auto before = ProximalRecurrence(grid, utility, allowed, options);
  EXPECT_GE(before.size(), 3u);
  for (int row = 0; row < 30; ++row) {
    for (int col = 0; col < 40; ++col) {
      if (row < 9 || row >= 19 || col < 11 || col >= 25) {
        utility[grid.Index({row, col})] = 1000.0f;
      }
    }
  }
  const auto after = ProximalRecurrence(grid, utility, allowed, options);
  ExpectSamePicks(before, after);
}

TEST(ProximalRecurrence, ScoresAreExactSums) {
  const kg_base::Grid grid = EvenGrid(-90, 25, 0.04, 9, 300);
  kg_base::Raster utility(grid.size(), 0.0f);
  utility[grid.Index({4, 10})] = 1.0f;
  utility[grid.Index({4, 11})] = 0x1p-30f;   // Counts to the last bit.
  utility[grid.Index({4, 290})] = 0x1p-29f;  // In the last strip.
  const auto picks = ProximalRecurrence(
      grid, utility, kg_base::Mask(grid.size(), 1), {5000, 5000, 9});
  ASSERT_EQ(2u, picks.size());
  EXPECT_EQ(1.0 + 0x1p-30, picks[0].score);
  EXPECT_EQ(0x1p-29, picks[1].score);
  EXPECT_TRUE((kg_base::Cell{3, 290}) == picks[1].cell);
}

TEST(ProximalRecurrence, BreaksTiesByRowThenColumn) {
  std::mt19937 rng(22);
  const kg_base::Grid grid = EvenGrid(-90, 25, 0.04, 15, 17);
  for (int round = 0; round < 10; ++round) {
    kg_base::Raster utility(grid.size());
    for (float& u : utility) u = static_cast<float>(rng() % 3) * 0.25f;
    const kg_base::Mask allowed(grid.size(), 1);
    const RecurrenceOptions options = {6000, 9000, 20};
    ExpectSamePicks(Naive(grid, utility, allowed, options),
                    ProximalRecurrence(grid, utility, allowed, options));
  }
  const kg_base::Raster flat(grid.size(), 0.1f);
  const auto picks =
      ProximalRecurrence(grid, flat, kg_base::Mask(grid.size(), 1), {0, 0, 3});
  ASSERT_EQ(3u, picks.size());
  for (int i = 0; i < 3; ++i) {
    EXPECT_TRUE((kg_base::Cell{0, i}) == picks[i].cell);
  }
}

TEST(ProximalRecurrence, PicksNothingWithoutValueOrLeave) {
  const kg_base::Grid grid = EvenGrid(0, 0, 0.04, 5, 5);
  const kg_base::Raster none(25, 0.0f), some(25, 1.0f);
  const kg_base::Mask all(25, 1), nowhere(25, 0);
  EXPECT_TRUE(ProximalRecurrence(grid, none, all, {1e4, 1e4, 5}).empty());
  EXPECT_TRUE(ProximalRecurrence(grid, some, nowhere, {1e4, 1e4, 5}).empty());
  EXPECT_TRUE(ProximalRecurrence(grid, some, all, {1e4, 1e4, 0}).empty());
}

TEST(ProximalRecurrence, RefusesRastersOfAnotherSize) {
  const kg_base::Grid grid = EvenGrid(0, 0, 0.04, 5, 5);
  EXPECT_THROW(
      ProximalRecurrence(grid, kg_base::Raster(24), kg_base::Mask(25), {}),
      std::logic_error);
  EXPECT_THROW(ProximalRecurrence(grid, kg_base::Raster(25, 1.0f),
                                  kg_base::Mask(25, 1), {-1.0, 1.0, 1}),
               std::logic_error);
}

TEST(DiscSum, CountsTheCellsOfTheDisc) {
  const kg_base::Grid grid = EvenGrid(0, -0.2, 0.04, 11, 11);  // 4.45 km cells.
  const kg_base::Raster ones(121, 1.0f);
  EXPECT_DOUBLE_EQ(1.0, DiscSum(grid, ones, {5, 5}, 0).score);
  EXPECT_DOUBLE_EQ(5.0, DiscSum(grid, ones, {5, 5}, 5000).score);
  EXPECT_DOUBLE_EQ(9.0, DiscSum(grid, ones, {5, 5}, 6500).score);
  EXPECT_DOUBLE_EQ(4.0, DiscSum(grid, ones, {0, 0}, 6500).score);
  EXPECT_EQ((std::vector<int>{0, 1, 11, 12}),
            DiscSum(grid, ones, {0, 0}, 6500).footprint);
}

}  // namespace
}  // namespace kg_compiler
