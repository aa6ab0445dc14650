#include "kg_compiler/traversal/sight.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "kg_compiler/testing/test_world.h"
#include "kg_compiler/traversal/arrivals.h"
#include "kg_compiler/traversal/testing/test_flow_world.h"

namespace kg_compiler {
namespace {

TEST(LineOfSight, SeesEveryCellThatALineTouches) {
  std::mt19937 rng(1);
  int clear = 0, blocked = 0;
  for (int round = 0; round < 3000; ++round) {
    TestFlowWorld sea(UniformFlow(EvenGrid(-91, 24, 0.04, 20, 20), 0, 0));
    sea.open = RandomMask(rng, 400, 0.9);
    const VoyageRequest voyage = sea.From(Glider(1), {{-91, 24}, 0, 1});
    const LineOfSight sight(voyage.world, {0, 20, 0, 20});
    const kg_base::GridPoint a{Uniform(rng, 0, 19), Uniform(rng, 0, 19)};
    const kg_base::GridPoint b{Uniform(rng, 0, 19), Uniform(rng, 0, 19)};
    const kg_base::Cell first = CellOf(sea.field.grid, a);
    bool open = true;
    for (int k = 0; k <= 5000; ++k) {
      const kg_base::Cell cell =
          CellOf(sea.field.grid, {a.row + (b.row - a.row) * k / 5000,
                                  a.col + (b.col - a.col) * k / 5000});
      open = open && (cell == first || sea.open[sea.field.grid.Index(cell)]);
    }
    const bool got = sight.IsClear(a, b);
    if (!open) {
      ASSERT_FALSE(got);
    } else if (!got) {
      // The sampling may miss a sliver: then a line slightly to the side is
      // blocked as well.
      bool sliver = false;
      for (const double d : {-2e-3, 2e-3}) {
        sliver = sliver ||
                 !sight.IsClear({a.row + d, a.col}, {b.row + d, b.col}) ||
                 !sight.IsClear({a.row, a.col + d}, {b.row, b.col + d});
      }
      ASSERT_TRUE(sliver);
    }
    ++(got ? clear : blocked);
  }
  EXPECT_GT(clear, 300);
  EXPECT_GT(blocked, 300);
}

TEST(LineOfSight, DoesNotSlipThroughACorner) {
  TestFlowWorld sea(UniformFlow(EvenGrid(-91, 24, 0.04, 5, 5), 0, 0));
  const VoyageRequest voyage = sea.From(Glider(1), {{-91, 24}, 0, 1});
  const LineOfSight sight(voyage.world, {0, 5, 0, 5});
  EXPECT_TRUE(sight.IsClear({1, 1}, {3, 3}));
  sea.open[1 * 5 + 2] = 0;
  EXPECT_FALSE(sight.IsClear({1, 1}, {3, 3}));
  EXPECT_FALSE(sight.IsClear({3, 3}, {1, 1}));
}

TEST(LineOfSight, IsDefinedForEveryPositionAndCell) {
  const TestFlowWorld sea(UniformFlow(EvenGrid(-91, 24, 0.04, 20, 20), 0, 0));
  const VoyageRequest voyage = sea.From(Glider(1), {{-91, 24}, 0, 1});
  // The box is larger than the grid: cells off the grid are closed anyway.
  LineOfSight sight(voyage.world, {-9, 99, -9, 99});
  EXPECT_TRUE(sight.IsOpen({19, 19}));
  EXPECT_FALSE(sight.IsOpen({20, 19}));
  EXPECT_FALSE(sight.IsOpen({-1, 0}));
  EXPECT_TRUE(sight.NearClosed({20, 3}));
  EXPECT_TRUE(sight.NearClosed({3, -1}));
  EXPECT_FALSE(sight.NearClosed({19, 19}));
  EXPECT_TRUE(sight.IsClear({3, 3}, {3, 19.4}));
  for (const double bad : {19.6, 1e300, HUGE_VAL, -HUGE_VAL, 0.0 + kGap}) {
    EXPECT_FALSE(sight.IsClear({3, 3}, {3, bad}));
    EXPECT_FALSE(sight.IsClear({3, 3}, {bad, 3}));
  }
  EXPECT_FALSE(sight.IsClear({kGap, 3}, {0, 0}));
  EXPECT_FALSE(sight.IsClear({3, HUGE_VAL}, {0, 0}));
  const kg_base::Grid& grid = sea.field.grid;
  EXPECT_EQ((kg_base::Cell{19, 0}), CellOf(grid, {3e9, -3e9}));
  EXPECT_EQ((kg_base::Cell{0, 19}), CellOf(grid, {-HUGE_VAL, HUGE_VAL}));
  EXPECT_EQ((kg_base::Cell{0, 0}), CellOf(grid, {kGap, kGap}));
}

TEST(ArrivalTiles, HaveNoArrivalOffTheGrid) {
  const kg_base::Grid grid = EvenGrid(-91, 24, 0.04, 20, 20);
  ArrivalTiles arrivals(grid);
  arrivals.At({19, 19}).arrival_s = 1.0;
  EXPECT_EQ(1.0, arrivals.Arrival_s({19, 19}));
  EXPECT_TRUE(std::isinf(arrivals.Arrival_s({20, 19})));
  EXPECT_TRUE(std::isinf(arrivals.Arrival_s({0, -1})));
  EXPECT_THROW(arrivals.At({20, 19}), std::logic_error);
}

TEST(LineOfSight, FindsCornersToGoRoundAndWhatIsNearTheCoast) {
  TestFlowWorld sea(UniformFlow(EvenGrid(-91, 24, 0.04, 20, 20), 0, 0));
  sea.open[10 * 20 + 10] = 0;
  const VoyageRequest voyage = sea.From(Glider(1), {{-91, 24}, 0, 1});
  LineOfSight sight(voyage.world, {0, 20, 0, 20});
  EXPECT_EQ(1u, sight.Corners({9, 9}));
  EXPECT_EQ(0u, sight.Corners({9, 10}));
  EXPECT_EQ(8u, sight.Corners({11, 11}));
  EXPECT_TRUE(sight.NearClosed({8, 8}));
  EXPECT_FALSE(sight.NearClosed({2, 2}));
  sea.open[9 * 20 + 10] = 0;  // Two closed cells in a row.
  EXPECT_EQ(0u, sight.Corners({9, 9}));
  EXPECT_EQ(1u, sight.Corners({8, 9}));
}

}  // namespace
}  // namespace kg_compiler
