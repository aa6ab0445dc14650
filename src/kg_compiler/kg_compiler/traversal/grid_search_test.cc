#include "kg_compiler/traversal/testing/grid_search.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "kg_compiler/testing/test_world.h"

namespace kg_compiler {
namespace {

TEST(Moves, AreSixteenOrThirtyTwoDirections) {
  for (const int count : {16, 32}) {
    const std::vector<Move> moves = NeighbourMoves(count);
    EXPECT_EQ(count, static_cast<int>(moves.size()));
    std::vector<double> directions;
    for (const Move& move : moves) {
      directions.push_back(std::atan2(move.rows, move.cols));
    }
    std::sort(directions.begin(), directions.end());
    for (std::size_t i = 1; i < directions.size(); ++i) {
      EXPECT_GT(directions[i], directions[i - 1] + 0.1);
    }
  }
}

TEST(Moves, TouchBothCellsBesideACorner) {
  for (const Move& move : NeighbourMoves(32)) {
    const auto touches = [&](int r, int c) {
      return std::count(move.touched.begin(), move.touched.end(),
                        kg_base::Cell{r, c}) == 1;
    };
    if (move.rows == 1 && move.cols == 1) {
      EXPECT_EQ(3u, move.touched.size());
      EXPECT_TRUE(touches(0, 1) && touches(1, 0) && touches(1, 1));
    }
    if (move.rows == 3 && move.cols == 1) {  // A corner in the middle.
      EXPECT_EQ(5u, move.touched.size());
      EXPECT_TRUE(touches(1, 0) && touches(2, 0) && touches(1, 1));
      EXPECT_FALSE(touches(3, 0));
    }
  }
}

// A move equals its leg flown with kSearch, except for the time estimate at the
// middle of each part.
TEST(Mover, AgreesWithTheLegFlown) {
  std::mt19937 rng(41);
  int made = 0, differ = 0;
  for (int round = 0; round < 20; ++round) {
    const kg_base::Grid grid = UnevenGrid(rng, 30, 30);
    const kg_base::VectorField field = RandomFlow(rng, grid, 0.15, 7200, 86400);
    const kg_base::Mask open = RandomMask(rng, grid.size(), 0.95);
    MotionModel motion;
    motion.cruise_mps = 0.6;
    motion.boost_gain = 0.9;
    const VoyageRequest voyage{{&field, &open, nullptr},
                               motion,
                               {grid.Centre({15, 15}), 3000.0, 86400.0},
                               {}};
    const Mover mover(voyage);
    const LegFlyer flyer(voyage);
    for (const Move& move : NeighbourMoves(32)) {
      const kg_base::Cell from{15, 15}, to{15 + move.rows, 15 + move.cols};
      if (!mover.MayEnter(from)) continue;
      const auto moved = mover.Arrival(move, from, 5000.0);
      const auto flown = flyer.Fly({grid.Centre(from), grid.Centre(to), 5000.0},
                                   {0.05, kSearch.slack});
      differ += moved.has_value() != flown.has_value();
      if (!moved || !flown) continue;
      EXPECT_NEAR(1.0, (*moved - 5000) / (flown->arrive_s - 5000), 0.04);
      ++made;
    }
  }
  EXPECT_GT(made, 300);
  EXPECT_LT(differ, 20);
}

}  // namespace
}  // namespace kg_compiler
