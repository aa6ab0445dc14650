#include "kg_compiler/control_plane/cropped_recurrence.h"

#include <gtest/gtest.h>

#include "kg_compiler/testing/test_world.h"

namespace kg_compiler {
namespace {

void ExpectSamePicks(const std::vector<RecurrencePick>& whole,
                     const std::vector<RecurrencePick>& part) {
  ASSERT_EQ(whole.size(), part.size());
  for (std::size_t i = 0; i < whole.size(); ++i) {
    EXPECT_EQ(whole[i].cell, part[i].cell);
    EXPECT_EQ(whole[i].score, part[i].score);
    EXPECT_EQ(whole[i].footprint, part[i].footprint);
  }
}

// A random blob of allowed cells, often at the edge of the grid.
kg_base::Mask Blob(std::mt19937& rng, const kg_base::Grid& grid) {
  const double row = Uniform(rng, 0, grid.rows());
  const double col = Uniform(rng, 0, grid.cols());
  const double size = Uniform(rng, 0, 12);
  kg_base::Mask mask(grid.size(), 0);
  for (int r = 0; r < grid.rows(); ++r) {
    for (int c = 0; c < grid.cols(); ++c) {
      const double away = std::hypot(r - row, c - col);
      mask[grid.Index({r, c})] = away <= size && rng() % 4 != 0;
    }
  }
  return mask;
}

// Few distinct or constant values, so that many discs tie.
kg_base::Raster Utility(std::mt19937& rng, std::size_t size) {
  const bool flat = rng() % 2;
  kg_base::Raster utility(size);
  for (float& u : utility) {
    u = flat ? 0.25f * (rng() % 3) : static_cast<float>(Uniform(rng, 0, 1));
  }
  utility[rng() % size] = static_cast<float>(Uniform(rng, 1, 300));
  return utility;
}

std::vector<int> CellsOf(const kg_base::Mask& mask) {
  std::vector<int> cells;
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (mask[i]) cells.push_back(static_cast<int>(i));
  }
  return cells;
}

TEST(RecurrenceWithin, PicksWhatTheWholeGridPicksToTheBit) {
  std::mt19937 rng(3);
  int picks = 0;
  PickMemo memo;  // Reused across cases, as between compiles.
  for (int i = 0; i < 120; ++i) {
    kg_base::Grid grid = i % 2 ? UnevenGrid(rng, 45, 60)
                               : EvenGrid(-92, i % 4 ? 23 : -25, 0.04, 45, 60);
    if (i % 5 == 0) memo = {};
    const kg_base::Raster utility = Utility(rng, grid.size());
    const kg_base::Mask allowed = Blob(rng, grid);
    RecurrenceOptions options;
    options.radius_m = Uniform(rng, 0, 30e3);
    options.spacing_m = Uniform(rng, 0, 40e3);
    options.count = 15;
    const auto whole = ProximalRecurrence(grid, utility, allowed, options);
    ExpectSamePicks(whole, RecurrenceWithin(grid, utility, CellsOf(allowed),
                                            options, &memo));
    picks += static_cast<int>(whole.size());
  }
  EXPECT_GT(picks, 300);
}

TEST(RecurrenceWithin, ReusesPicksOnlyIfTheirInputsAreUnchanged) {
  std::mt19937 rng(4);
  const kg_base::Grid grid = EvenGrid(-92, 23, 0.04, 45, 60);
  kg_base::Raster utility = RandomRaster(rng, grid.size(), 0, 1);
  utility[5] = 2.0f;
  std::vector<int> allowed = {static_cast<int>(grid.Index({20, 30}))};
  const RecurrenceOptions options{9000.0, 9000.0, 5};
  PickMemo memo;
  const double first =
      RecurrenceWithin(grid, utility, allowed, options, &memo)[0].score;
  memo.picks[0].score = -7.0;  // Marks reused picks.
  utility[7] = 0.5f;           // Far away.
  EXPECT_EQ(-7.0,
            RecurrenceWithin(grid, utility, allowed, options, &memo)[0].score);
  utility[grid.Index({20, 31})] = 0.0f;
  EXPECT_LT(RecurrenceWithin(grid, utility, allowed, options, &memo)[0].score,
            first);
  EXPECT_TRUE(RecurrenceWithin(grid, utility, {}, options, &memo).empty());
}

}  // namespace
}  // namespace kg_compiler
