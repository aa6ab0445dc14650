#include "kg_compiler/data_plane/distance_transform.h"

#include <gtest/gtest.h>

#include "kg_base/geo/geodesy.h"
#include "kg_compiler/testing/test_world.h"

namespace kg_compiler {
namespace {

TEST(GrowByCells, IsTheBruteForceEuclideanBuffer) {
  std::mt19937 rng(11);
  for (int round = 0; round < 20; ++round) {
    const kg_base::Grid grid = UnevenGrid(rng, 17, 23);
    const kg_base::Mask set = RandomMask(rng, grid.size(), 0.03);
    const double cells = round % 2 ? round % 7 : Uniform(rng, 0, 6);
    const kg_base::Mask grown = GrowByCells(grid, set, cells);
    for (int r = 0; r < 17; ++r) {
      for (int c = 0; c < 23; ++c) {
        bool near = false;
        for (int i = 0; i < 17 * 23; ++i) {
          if (set[i]) near |= std::hypot(i / 23 - r, i % 23 - c) <= cells;
        }
        EXPECT_EQ(near, grown[grid.Index({r, c})] == 1) << r << " " << c;
      }
    }
  }
}

TEST(GrowByCells, LeavesAnEmptyAndAFullSetAlone) {
  const kg_base::Grid grid = EvenGrid(0, 0, 1, 4, 5);
  const kg_base::Mask none(20, 0), all(20, 1);
  EXPECT_EQ(none, GrowByCells(grid, none, 3));
  EXPECT_EQ(all, GrowByCells(grid, all, 3));
}

TEST(DistanceTo, IsTheBruteForceMinimum) {
  std::mt19937 rng(12);
  for (int round = 0; round < 10; ++round) {
    const kg_base::Grid grid = UnevenGrid(rng, 19, 14);
    const kg_base::Mask set = RandomMask(rng, grid.size(), 0.04);
    const std::vector<double> distance = DistanceTo_m(grid, set);
    for (int i = 0; i < 19 * 14; ++i) {
      double least = std::numeric_limits<double>::infinity();
      for (int j = 0; j < 19 * 14; ++j) {
        if (!set[j]) continue;
        least =
            std::min(least, kg_base::Distance_m(grid.Centre({i / 14, i % 14}),
                                                grid.Centre({j / 14, j % 14})));
      }
      if (std::isinf(least)) {
        EXPECT_TRUE(std::isinf(distance[i]));
      } else {
        EXPECT_NEAR(least, distance[i], 0.005 * least + 1e-6);
      }
    }
  }
}

}  // namespace
}  // namespace kg_compiler
