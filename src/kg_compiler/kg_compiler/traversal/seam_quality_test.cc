// Quality of traversal against closed forms, brute force and real files.

#include "kg_compiler/traversal/testing/seam_quality.h"

#include <gtest/gtest.h>

#include "kg_base/raster/grid.h"

namespace kg_compiler {
namespace {

using kg_base::LonLat;

TEST(SeamQuality, IsWithinAFifthOfAPercentOfFiveClosedForms) {
  for (const ClosedForm& form : ClosedForms()) {
    SCOPED_TRACE(form.name);
    const SeamError error = AgainstOptimum(form, 60, 11);
    EXPECT_GT(error.targets, 8);
    EXPECT_EQ(0, error.missed);
    EXPECT_EQ(0, error.claimed);
    EXPECT_LE(error.mean, 0.0005);
    EXPECT_LE(error.most, 0.002);
    EXPECT_GE(error.least, -2e-5);
  }
}

// The cone of places reachable downstream need not contain its source.
TEST(SeamQuality, ReachesExactlyTheConeOfAStrongCurrent) {
  const ClosedForm form = closed_forms::Uniform("", 1.3, 0.8);
  const TestFlowWorld sea(form.field);
  const kg_base::DegreesPerMetre scale = kg_base::LocalScale(0.0);
  const Metres from{-20e3, -12e3};
  const ReachMap reach =
      ComputeReach(sea.From(Glider(1.0), {OnPlane(from), 0.0, kDay_s}));
  std::mt19937 rng(12);
  int inside = 0, outside = 0;
  for (int k = 0; k < 4000; ++k) {
    const kg_base::Cell cell{static_cast<int>(Uniform(rng, 0, 385)),
                             static_cast<int>(Uniform(rng, 0, 541))};
    const LonLat at = sea.field.grid.Centre(cell);
    const Metres to{at.lon_deg / scale.lon_deg, at.lat_deg / scale.lat_deg};
    const double optimum_s = form.optimum_s(from, to);
    const auto* found =
        reach.Find(static_cast<int>(sea.field.grid.Index(cell)));
    if (std::isfinite(optimum_s) && optimum_s > 300.0) {
      inside += found != nullptr;
      if (found) {
        EXPECT_NEAR(1.0, found->arrival_s / optimum_s, 0.03);
      }
      outside += found == nullptr;  // Missed: at the very edge.
    } else if (!std::isfinite(optimum_s)) {
      EXPECT_EQ(nullptr, found);
    }
  }
  EXPECT_GT(inside, 500);
  EXPECT_LE(outside, inside / 200);
}

// The same field sampled three times finer; bilinear interpolation makes both
// fields identical.
TestFlowWorld Finer(const TestFlowWorld& sea) {
  const auto fine = [](const std::vector<double>& axis) {
    std::vector<double> centres;
    for (std::size_t i = 0; i + 1 < axis.size(); ++i) {
      for (int k = 0; k < 3; ++k) {
        centres.push_back(axis[i] + (axis[i + 1] - axis[i]) * k / 3.0);
      }
    }
    centres.push_back(axis.back());
    return centres;
  };
  kg_base::VectorField field;
  field.grid = {fine(sea.field.grid.lon_deg()), fine(sea.field.grid.lat_deg())};
  for (const kg_base::FieldSlice& slice : sea.field.slices) {
    field.slices.push_back(
        {slice.time_s,
         ResampleBilinear(sea.field.grid, slice.east_mps, field.grid),
         ResampleBilinear(sea.field.grid, slice.north_mps, field.grid)});
  }
  TestFlowWorld finer(std::move(field));
  for (int r = 0; r < finer.field.grid.rows(); ++r) {
    for (int c = 0; c < finer.field.grid.cols(); ++c) {
      const auto cell = sea.field.grid.CellAt(finer.field.grid.Centre({r, c}));
      finer.open[finer.field.grid.Index({r, c})] =
          sea.open[sea.field.grid.Index(*cell)];
    }
  }
  return finer;
}

// Every place that Dijkstra reaches on a grid three times finer, and FlyTrack
// confirms on the original one, is found and not later, with or without land.
TEST(SeamQuality, ReachesAllPlacesOfAFineGridSearch) {
  std::mt19937 rng(13);
  int flown = 0, missed = 0, late = 0;
  for (int round = 0; round < 14; ++round) {
    const kg_base::Grid grid =
        round % 2 ? EvenGrid(-91, 24, 0.04, 40, 40) : UnevenGrid(rng, 40, 40);
    TestFlowWorld sea(
        RandomFlow(rng, grid, round % 3 ? 0.4 : 1.2, 7200, kDay_s));
    if (round % 2) sea.open = RandomMask(rng, grid.size(), 0.93);
    const kg_base::Cell source{20, 20};
    sea.open[grid.Index(source)] = 1;
    const TestFlowWorld fine = Finer(sea);
    const MotionModel motion = Glider(round % 4 < 2 ? 0.4 : 0.7);
    const VoyageDeparture departure{grid.Centre(source), 0.0, 0.7 * kDay_s};
    const VoyageRequest voyage = sea.From(motion, departure);
    const ReachMap reach = ComputeReach(voyage);
    const GridReach peer = GridSearch(fine.From(motion, departure), 32);
    for (int k = 0; k < 150; ++k) {
      const kg_base::Cell cell{static_cast<int>(Uniform(rng, 4, 36)),
                               static_cast<int>(Uniform(rng, 4, 36))};
      const int index =
          static_cast<int>(fine.field.grid.Index({3 * cell.row, 3 * cell.col}));
      if (!peer.Find(index)) continue;
      const auto wanted =
          FlyTrack(voyage, peer.Track(fine.field.grid, departure.from, index));
      if (!wanted) continue;
      ++flown;
      const auto got = Traverse(voyage, reach, wanted->track.back().position);
      missed += !got;
      late += got && got->travel_s > 1.002 * wanted->travel_s + 30.0;
    }
  }
  EXPECT_GT(flown, 300);
  EXPECT_LE(missed, flown / 200);
  EXPECT_LE(late, flown / 100);
}

TEST(SeamQuality, OnRealCurrentsReachesExactlyTheFlyablePlaces) {
  for (const char* file : kRealFiles) {
    const std::optional<TestFlowWorld> sea = RealSea(file);
    if (!sea) GTEST_SKIP() << file << " is not beside the repository";
    for (const double cruise_mps : {0.3, 0.5, 1.0}) {
      SCOPED_TRACE(std::string(file) + " " + std::to_string(cruise_mps));
      const SeamTruth truth = TruthOn(*sea, cruise_mps, {2, 7, 14});
      EXPECT_GT(truth.claimed, 10);
      EXPECT_EQ(0, truth.infeasible);
      EXPECT_LE(truth.missed, truth.reachable / 200);
      EXPECT_LE(truth.worst, 0.005);
      EXPECT_LE(truth.above_grid, 0.01);
    }
  }
}

}  // namespace
}  // namespace kg_compiler
