#include "kg_compiler/control_plane/work.h"

#include <gtest/gtest.h>

#include <cmath>

#include "kg_base/geo/geodesy.h"
#include "kg_compiler/testing/test_world.h"

namespace kg_compiler {
namespace {

constexpr double kSpeed_mps = 0.5;
constexpr double kDay_s = 86400.0;

// Open water of 81 x 81 cells of 1.1 km around (-90, 0) in a uniform current.
struct UniformSea {
  UniformSea(double east_mps, double north_mps)
      : grid(EvenGrid(-90.4, -0.4, 0.01, 81, 81)),
        field(UniformFlow(grid, east_mps, north_mps)),
        feasibility(grid.size(), 1.0f) {
    rules.motion = {kSpeed_mps, 10.0, 1.0, 1.0, 0.0};
    rules.hazard_range_m = 10e3;
    window.end_s = kDay_s;
    window.base_travel_m = kSpeed_mps * kDay_s;
  }
  void Close(kg_base::Cell cell, float why) {
    feasibility[grid.Index(cell)] = why;
  }
  MissionTensor Tensor() const {
    MissionTensor tensor;
    tensor.grid = grid;
    tensor.content =
        HoldLayers({{Layer::kFused, kg_base::Raster(grid.size(), 0.5f)},
                    {Layer::kFeasibility, feasibility},
                    {Layer::kAttenuation, kg_base::Raster(grid.size(), 1.0f)}});
    return tensor;
  }
  WorkMap From(std::vector<kg_base::LonLat> places) const {
    const MissionTensor tensor = Tensor();
    return ComputeWork(rules, window, {&tensor, &field}, places);
  }
  // Time from the middle: |d - c t| = V t. Nullopt if it cannot be reached.
  std::optional<double> Exact_s(kg_base::Cell cell, double east_mps) const {
    const kg_base::LonLat to = grid.Centre(cell);
    const kg_base::DegreesPerMetre scale = kg_base::LocalScale(0.0);
    const double x = (to.lon_deg + 90.0) / scale.lon_deg;
    const double y = to.lat_deg / scale.lat_deg;
    const double a = kSpeed_mps * kSpeed_mps - east_mps * east_mps;
    const double b = x * east_mps, d2 = x * x + y * y;
    const double root2 = b * b + a * d2;
    if (!(root2 >= 0.0)) return std::nullopt;
    const double t = d2 / (b + std::sqrt(root2));
    if (!(t >= 0.0) || !(t <= kDay_s)) return std::nullopt;
    return t;
  }

  kg_base::Grid grid;
  kg_base::VectorField field;
  kg_base::Raster feasibility;
  SeamRules rules;
  WindowRules window;
};

constexpr kg_base::LonLat kMiddle = {-90.0, 0.0};

TEST(Work, IsTheClosedFormInAUniformCurrent) {
  const UniformSea sea(0.2, 0.0);
  const WorkMap work = sea.From({kMiddle});
  EXPECT_EQ(kDay_s, work.budget_s);
  int compared = 0, missed = 0;
  for (int row = 0; row < 81; ++row) {
    for (int col = 0; col < 81; ++col) {
      const std::size_t cell = sea.grid.Index({row, col});
      const std::optional<double> exact_s = sea.Exact_s({row, col}, 0.2);
      const std::optional<double> share = work.Share(cell);
      if (!exact_s || *exact_s > 0.95 * kDay_s) continue;
      missed += !share;
      if (!share || std::hypot(row - 40, col - 40) < 3.0) continue;
      EXPECT_NEAR(*exact_s / kDay_s, *share, 0.03 * *exact_s / kDay_s);
      ++compared;
    }
  }
  EXPECT_GT(compared, 2000);
  EXPECT_LE(missed, compared / 200);  // Reach may miss 0.5 %.
}

TEST(Work, CostsMoreUpstream) {
  const UniformSea sea(0.3, 0.0);
  const WorkMap work = sea.From({kMiddle});
  for (int away = 1; away <= 8; ++away) {
    const auto upstream = work.Share(sea.grid.Index({40, 40 - away}));
    const auto across = work.Share(sea.grid.Index({40 + away, 40}));
    const auto downstream = work.Share(sea.grid.Index({40, 40 + away}));
    ASSERT_TRUE(upstream && across && downstream) << away;
    EXPECT_GT(*upstream, *across);
    EXPECT_GT(*across, *downstream);
  }
}

TEST(Work, NothingUpstreamIsReachedWhereTheCurrentIsStronger) {
  const UniformSea sea(0.9, 0.0);
  const WorkMap work = sea.From({kMiddle});
  for (int row = 0; row < 81; ++row) {
    for (int col = 0; col < 40; ++col) {
      EXPECT_EQ(CellAccess::kTooFar, work.access[sea.grid.Index({row, col})]);
    }
  }
  EXPECT_EQ(CellAccess::kReached, work.access[sea.grid.Index({40, 60})]);
}

TEST(Work, IsAnotherFromAnotherPoseAndTheLeastOfSeveral) {
  const UniformSea sea(0.1, 0.05);
  const kg_base::LonLat east = {-89.8, 0.1};
  const WorkMap one = sea.From({kMiddle});
  const WorkMap other = sea.From({east});
  const WorkMap both = sea.From({kMiddle, east});
  int differ = 0;
  for (std::size_t i = 0; i < sea.grid.size(); ++i) {
    const double a_s =
        one.access[i] == CellAccess::kReached ? one.time_s[i] : 1e9;
    const double b_s =
        other.access[i] == CellAccess::kReached ? other.time_s[i] : 1e9;
    differ += a_s != b_s;
    EXPECT_EQ(std::min(a_s, b_s) < 1e9, both.access[i] == CellAccess::kReached);
    if (std::min(a_s, b_s) < 1e9) {
      EXPECT_EQ(std::min(a_s, b_s), both.time_s[i]);
    }
  }
  EXPECT_GT(differ, 1000);
}

TEST(Work, SaysWhyACellIsNotReached) {
  UniformSea sea(0.0, 0.0);
  sea.Close({40, 45}, 0.0f);
  sea.Close({40, 35}, kGap);
  const WorkMap work = sea.From({kMiddle});
  EXPECT_EQ(CellAccess::kForbidden, work.access[sea.grid.Index({40, 45})]);
  EXPECT_EQ(CellAccess::kNoData, work.access[sea.grid.Index({40, 35})]);
  EXPECT_EQ(CellAccess::kReached, work.access[sea.grid.Index({40, 44})]);
  EXPECT_EQ(CellAccess::kTooFar, work.access[0]);  // 62 km; 43 km in a day.
  EXPECT_FALSE(work.Share(0));
}

TEST(Work, ReachesNothingFromAForbiddenPlaceOrWithoutTime) {
  UniformSea sea(0.0, 0.0);
  sea.Close({40, 40}, 0.0f);
  const auto reached = [&](const WorkMap& work) {
    return std::count(work.access.begin(), work.access.end(),
                      CellAccess::kReached);
  };
  EXPECT_EQ(0, reached(sea.From({kMiddle})));
  EXPECT_EQ(0, reached(sea.From({{0.0, 50.0}})));
  EXPECT_EQ(0, reached(sea.From({})));
  EXPECT_LT(0, reached(sea.From({{-89.9, 0.0}})));
  sea.window.begin_s = sea.window.end_s;
  EXPECT_EQ(0, reached(sea.From({{-89.9, 0.0}})));
}

TEST(FusedView, IsTheValueLessWhatTheWayTakes) {
  UniformSea sea(0.1, 0.0);
  sea.Close({42, 42}, 0.0f);
  const WorkMap work = sea.From({kMiddle});
  const kg_base::Raster view = FusedView(sea.Tensor(), work);
  for (std::size_t i = 0; i < view.size(); ++i) {
    const float wanted = work.access[i] == CellAccess::kReached
                             ? 0.5f * (1.0f - work.time_s[i] / 86400.0f)
                             : 0.0f;
    EXPECT_NEAR(wanted, view[i], 1e-6f);
  }
  EXPECT_NEAR(0.5, view[sea.grid.Index({40, 40})], 0.01);
  EXPECT_EQ(0.0f, view[sea.grid.Index({42, 42})]);
}

}  // namespace
}  // namespace kg_compiler
