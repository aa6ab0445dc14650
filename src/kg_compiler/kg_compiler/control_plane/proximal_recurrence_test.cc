#include "kg_compiler/control_plane/proximal_recurrence.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "kg_compiler/test_world.h"
#include "kg_core/geo/geodesy.h"

namespace kg_compiler {
namespace {

bool Within(const kg_core::Grid& grid, int from, int to, double reach_m) {
  const kg_core::LonLat a =
      grid.Centre({from / grid.cols(), from % grid.cols()});
  const kg_core::LonLat b = grid.Centre({to / grid.cols(), to % grid.cols()});
  const double middle_deg = 0.5 * (a.lat_deg + b.lat_deg);
  const double north =
      (b.lat_deg - a.lat_deg) / kg_core::LocalScale(middle_deg).lat_deg;
  const double east = std::abs(b.lon_deg - a.lon_deg) *
                      (1.0 / kg_core::LocalScale(b.lat_deg).lon_deg);
  return east * east + north * north <= reach_m * reach_m;
}

// For every cell, the cells within reach of it.
std::vector<std::vector<int>> Discs(const kg_core::Grid& grid, double reach_m) {
  const int size = static_cast<int>(grid.size());
  std::vector<std::vector<int>> discs(size);
  for (int i = 0; i < size; ++i) {
    for (int j = 0; j < size; ++j) {
      if (Within(grid, i, j, reach_m)) discs[i].push_back(j);
    }
  }
  return discs;
}

// Every disc summed anew, cell by cell, for every pick.
std::vector<Pick> Naive(const kg_core::Grid& grid, kg_core::Raster utility,
                        kg_core::Mask allowed,
                        const RecurrenceOptions& options) {
  std::vector<Pick> picks;
  const int size = static_cast<int>(grid.size());
  const auto footprints = Discs(grid, options.radius_m);
  const auto spacings = Discs(grid, options.spacing_m);
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

void ExpectSamePicks(const std::vector<Pick>& wanted,
                     const std::vector<Pick>& got) {
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
    const kg_core::Grid grid = UnevenGrid(rng, 21, 26);
    kg_core::Raster utility = RandomRaster(rng, grid.size(), 0, 1);
    const kg_core::Mask land = RandomMask(rng, grid.size(), 0.2);
    for (std::size_t i = 0; i < land.size(); ++i) {
      if (land[i]) utility[i] = 0.0f;
    }
    const RecurrenceOptions options = {Uniform(rng, 0, 30e3),
                                       Uniform(rng, 0, 30e3), 12};
    const kg_core::Mask allowed = RandomMask(rng, grid.size(), 0.7);
    ExpectSamePicks(Naive(grid, utility, allowed, options),
                    ProximalRecurrence(grid, utility, allowed, options));
  }
}

TEST(ProximalRecurrence, BreaksTiesByRowThenColumn) {
  std::mt19937 rng(22);
  const kg_core::Grid grid = EvenGrid(-90, 25, 0.04, 15, 17);
  for (int round = 0; round < 10; ++round) {
    kg_core::Raster utility(grid.size());
    for (float& u : utility) u = static_cast<float>(rng() % 3) * 0.25f;
    const kg_core::Mask allowed(grid.size(), 1);
    const RecurrenceOptions options = {6000, 9000, 20};
    ExpectSamePicks(Naive(grid, utility, allowed, options),
                    ProximalRecurrence(grid, utility, allowed, options));
  }
  const kg_core::Raster flat(grid.size(), 0.1f);
  const auto picks =
      ProximalRecurrence(grid, flat, kg_core::Mask(grid.size(), 1), {0, 0, 3});
  ASSERT_EQ(3u, picks.size());
  for (int i = 0; i < 3; ++i)
    EXPECT_TRUE((kg_core::Cell{0, i}) == picks[i].cell);
}

TEST(ProximalRecurrence, PicksNothingWithoutValueOrLeave) {
  const kg_core::Grid grid = EvenGrid(0, 0, 0.04, 5, 5);
  const kg_core::Raster none(25, 0.0f), some(25, 1.0f);
  const kg_core::Mask all(25, 1), nowhere(25, 0);
  EXPECT_TRUE(ProximalRecurrence(grid, none, all, {1e4, 1e4, 5}).empty());
  EXPECT_TRUE(ProximalRecurrence(grid, some, nowhere, {1e4, 1e4, 5}).empty());
  EXPECT_TRUE(ProximalRecurrence(grid, some, all, {1e4, 1e4, 0}).empty());
}

TEST(ProximalRecurrence, RefusesRastersOfAnotherSize) {
  const kg_core::Grid grid = EvenGrid(0, 0, 0.04, 5, 5);
  EXPECT_THROW(
      ProximalRecurrence(grid, kg_core::Raster(24), kg_core::Mask(25), {}),
      std::logic_error);
}

TEST(DiscSum, CountsTheCellsOfTheDisc) {
  const kg_core::Grid grid = EvenGrid(0, -0.2, 0.04, 11, 11);  // 4.45 km cells.
  const kg_core::Raster ones(121, 1.0f);
  EXPECT_DOUBLE_EQ(1.0, DiscSum(grid, ones, {5, 5}, 0).score);
  EXPECT_DOUBLE_EQ(5.0, DiscSum(grid, ones, {5, 5}, 5000).score);
  EXPECT_DOUBLE_EQ(9.0, DiscSum(grid, ones, {5, 5}, 6500).score);
  EXPECT_DOUBLE_EQ(4.0, DiscSum(grid, ones, {0, 0}, 6500).score);
  EXPECT_EQ((std::vector<int>{0, 1, 11, 12}),
            DiscSum(grid, ones, {0, 0}, 6500).footprint);
}

}  // namespace
}  // namespace kg_compiler
