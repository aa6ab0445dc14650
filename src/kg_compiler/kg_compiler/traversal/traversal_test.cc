#include "kg_compiler/traversal/traversal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "kg_base/geo/geodesy.h"
#include "kg_compiler/testing/test_world.h"
#include "kg_compiler/traversal/sight.h"
#include "kg_compiler/traversal/testing/test_flow_world.h"

namespace kg_compiler {
namespace {

using kg_base::LonLat;
using kg_base::VectorField;

kg_base::Grid TestGrid() { return EvenGrid(-91, 24, 0.04, 50, 50); }

// Ground speed [m/s] towards a bearing in a uniform current.
double ClosedFormSpeed(double v, double east, double north, double bearing) {
  const double along = east * std::sin(bearing) + north * std::cos(bearing);
  const double across = east * std::cos(bearing) - north * std::sin(bearing);
  return along + std::sqrt(v * v - across * across);
}

TEST(Traverse, TakesTheClosedFormsTimeInAUniformCurrent) {
  std::mt19937 rng(31);
  int flown = 0;
  for (int round = 0; round < 60; ++round) {
    const double east = Uniform(rng, -0.4, 0.4),
                 north = Uniform(rng, -0.4, 0.4);
    const TestFlowWorld sea(UniformFlow(TestGrid(), east, north));
    const LonLat from{-90.0, 25.0};
    const double bearing = Uniform(rng, 0, 2 * kg_base::kPi);
    const LonLat to =
        kg_base::Destination(from, bearing, Uniform(rng, 3e3, 40e3));
    const double speed = ClosedFormSpeed(0.5, east, north, bearing);
    const double wanted_s = kg_base::Distance_m(from, to) / speed;
    if (!(speed > 0.05) || wanted_s > 0.95 * kDay_s) continue;
    const auto flight = sea.Go(Glider(0.5), from, to);
    ASSERT_TRUE(flight);
    EXPECT_NEAR(1.0, flight->travel_s / wanted_s, 0.01);
    ++flown;
  }
  EXPECT_GT(flown, 30);
}

TEST(Traverse, CannotGoAgainstACurrentStrongerThanItself) {
  const TestFlowWorld sea(UniformFlow(TestGrid(), 0.6, 0.0));
  EXPECT_FALSE(sea.Go(Glider(0.5), {-90, 25}, {-90.2, 25}));
  EXPECT_TRUE(sea.Go(Glider(0.5), {-90, 25}, {-89.8, 25}));
  EXPECT_FALSE(sea.Go(Glider(0.5), {-90, 25}, {-90.0, 25.2}));
}

// d = V t + c0 t + k t^2 / 2 for a current that grows along the way.
TEST(Traverse, FollowsACurrentThatGrowsWithTime) {
  VectorField field = UniformFlow(TestGrid(), 0.1, 0.0);
  field.slices.push_back(field.slices[0]);
  field.slices[1].time_s = kDay_s;
  for (float& u : field.slices[1].east_mps) u = 0.5f;
  const TestFlowWorld sea(field);
  const LonLat from{-90.5, 25}, to{-90.0, 25};
  const auto flight = sea.Go(Glider(0.5), from, to);
  ASSERT_TRUE(flight);
  const double k = 0.4 / kDay_s, t = flight->travel_s;
  EXPECT_NEAR(kg_base::Distance_m(from, to), 0.6 * t + k * t * t / 2, 50.0);
}

// |x - int c| = V T is the earliest any vehicle can arrive in c(t).
TEST(Traverse, NeverBeatsTheOptimumInARotatingTide) {
  VectorField field;
  field.grid = TestGrid();
  for (double t = 0; t <= kDay_s; t += 1800) {
    const double turn = 2 * kg_base::kPi * t / 43200;
    field.slices.push_back(
        UniformFlow(field.grid, 0.25 * std::cos(turn), 0.25 * std::sin(turn))
            .slices[0]);
    field.slices.back().time_s = t;
  }
  const TestFlowWorld sea(field);
  std::mt19937 rng(32);
  for (int round = 0; round < 20; ++round) {
    const LonLat from{-90.0, 25.0};
    const double bearing = Uniform(rng, 0, 2 * kg_base::kPi);
    const double d = Uniform(rng, 5e3, 25e3);
    const auto flight =
        sea.Go(Glider(0.5), from, kg_base::Destination(from, bearing, d));
    ASSERT_TRUE(flight);
    double x = 0, y = 0, t = 0;
    while (std::hypot(d * std::sin(bearing) - x, d * std::cos(bearing) - y) >
           0.5 * t) {
      const double turn = 2 * kg_base::kPi * t / 43200;
      x += 0.25 * std::cos(turn) * 10;
      y += 0.25 * std::sin(turn) * 10;
      t += 10;
    }
    EXPECT_GE(flight->travel_s, 0.995 * t);
    EXPECT_LE(flight->travel_s, 1.15 * t);
  }
}

TEST(Traverse, RoundsAVortexFasterWithItThanAgainstIt) {
  VectorField field = UniformFlow(TestGrid(), 0, 0);
  for (int r = 0; r < 50; ++r) {
    for (int c = 0; c < 50; ++c) {
      const double dy = (r - 25) / 10.0, dx = (c - 25) / 10.0;
      const double swirl = 0.5 * std::exp(-(dx * dx + dy * dy) / 2);
      field.slices[0].east_mps[r * 50 + c] = static_cast<float>(-swirl * dy);
      field.slices[0].north_mps[r * 50 + c] = static_cast<float>(swirl * dx);
    }
  }
  const TestFlowWorld sea(field), still(UniformFlow(TestGrid(), 0, 0));
  const LonLat west{-90.4, 25}, south{-90, 24.6};
  const MotionModel motion = Glider(0.5);
  const double with = sea.Go(motion, west, south, 4 * kDay_s)->travel_s;
  const double against = sea.Go(motion, south, west, 4 * kDay_s)->travel_s;
  const double calm = still.Go(motion, west, south, 4 * kDay_s)->travel_s;
  EXPECT_LT(with, calm);
  EXPECT_LT(calm, against);
  EXPECT_GT(with + against, 2 * calm);
}

// Samples the track at 1/1000 of each leg: every cell must be open.
void ExpectOpen(const TestFlowWorld& sea, const FlownPath& flight) {
  for (std::size_t i = 0; i + 1 < flight.track.size(); ++i) {
    const LonLat a = flight.track[i].position, b = flight.track[i + 1].position;
    for (int k = 0; k <= 1000; ++k) {
      const auto cell = sea.field.grid.CellAt(
          {a.lon_deg + (b.lon_deg - a.lon_deg) * k / 1000.0,
           a.lat_deg + (b.lat_deg - a.lat_deg) * k / 1000.0});
      ASSERT_TRUE(cell && sea.open[sea.field.grid.Index(*cell)]);
    }
  }
}

TEST(Traverse, AvoidsThinBarriersOfClosedCells) {
  TestFlowWorld sea(UniformFlow(TestGrid(), 0, 0));
  for (int r = 15; r < 50; ++r) sea.open[r * 50 + 25] = 0;
  const LonLat from{-90.2, 25}, to{-89.8, 25};
  const auto round = sea.Go(Glider(2.0), from, to);
  ASSERT_TRUE(round);
  EXPECT_GT(round->track.size(), 3u);
  ExpectOpen(sea, *round);
  for (int r = 0; r < 15; ++r) sea.open[r * 50 + 25] = 0;
  EXPECT_FALSE(sea.Go(Glider(2.0), from, to));
}

TEST(Traverse, DoesNotPassBetweenDiagonalClosedCells) {
  TestFlowWorld sea(UniformFlow(TestGrid(), 0, 0));
  for (int r = 0; r < 50; ++r) sea.open[r * 50 + r] = 0;
  EXPECT_FALSE(sea.Go(Glider(1.0), {-90.2, 25.2}, {-89.8, 24.8}));
}

TEST(Traverse, FliesWhatAnIndependentIntegratorConfirms) {
  std::mt19937 rng(33);
  int flown = 0, bent = 0;
  for (int round = 0; round < 40; ++round) {
    const kg_base::Grid grid = round % 2 ? TestGrid() : UnevenGrid(rng, 50, 50);
    TestFlowWorld sea(
        RandomFlow(rng, grid, round % 3 ? 0.6 : 1.5, 3600, kDay_s));
    sea.open = RandomMask(rng, grid.size(), 0.97);
    const MotionModel motion = Glider(round % 2 ? 0.3 : 0.8);
    const LonLat from =
        grid.Position({Uniform(rng, 15, 35), Uniform(rng, 15, 35)});
    const VoyageDeparture departure{from, 0.0, kDay_s};
    const ReachMap reach = ComputeReach(sea.From(motion, departure));
    for (int k = 0; k < 12; ++k) {
      const LonLat to =
          grid.Position({Uniform(rng, 8, 42), Uniform(rng, 8, 42)});
      const auto flight = Traverse(sea.From(motion, departure), reach, to);
      if (!flight) continue;
      ++flown;
      bent += flight->track.size() > 3;
      EXPECT_LE(flight->travel_s, kDay_s);
      const auto again = Refly(sea, motion).Fly(*flight);
      ASSERT_TRUE(again);
      EXPECT_NEAR(1.0, flight->travel_s / *again, 0.005);
    }
  }
  EXPECT_GT(flown, 100);
  EXPECT_GT(bent, 20);
}

TEST(Traverse, ClaimsExactlyWhatItFliesAndIsNeverSlowerThanStraight) {
  std::mt19937 rng(34);
  int compared = 0;
  for (int round = 0; round < 25; ++round) {
    TestFlowWorld sea(RandomFlow(rng, TestGrid(), 0.7, 10800, kDay_s));
    const MotionModel motion = Glider(0.6);
    const VoyageDeparture departure{
        sea.field.grid.Position({Uniform(rng, 15, 35), Uniform(rng, 15, 35)}),
        0.0, kDay_s};
    const ReachMap reach = ComputeReach(sea.From(motion, departure));
    for (int k = 0; k < 8; ++k) {
      const LonLat to =
          sea.field.grid.Position({Uniform(rng, 10, 40), Uniform(rng, 10, 40)});
      const auto flight = Traverse(sea.From(motion, departure), reach, to);
      const auto straight =
          FlyTrack(sea.From(motion, departure), {departure.from, to});
      if (straight) {
        ASSERT_TRUE(flight);
        EXPECT_LE(flight->travel_s, straight->travel_s);
        ++compared;
      }
      if (!flight) continue;
      std::vector<LonLat> via;
      for (const TimedPoint& p : flight->track) via.push_back(p.position);
      const auto again = FlyTrack(sea.From(motion, departure), via);
      ASSERT_TRUE(again);
      EXPECT_NEAR(flight->travel_s / 3600, again->travel_s / 3600, 1e-9);
      EXPECT_NEAR(flight->energy_j, again->energy_j, 1e-6);
    }
  }
  EXPECT_GT(compared, 30);
}

TEST(ComputeReach, NeverShrinksWithALaterDeadlineNorArrivesLater) {
  std::mt19937 rng(35);
  const TestFlowWorld sea(RandomFlow(rng, TestGrid(), 0.7, 10800, kDay_s));
  std::size_t last = 0;
  for (double deadline_s = 10800; deadline_s <= kDay_s; deadline_s += 10800) {
    const ReachMap reach =
        ComputeReach(sea.From(Glider(0.5), {{-90, 25}, 0.0, deadline_s}));
    EXPECT_GE(reach.cells.size(), last);
    last = reach.cells.size();
    for (const ReachedCell& c : reach.cells) EXPECT_LE(c.arrival_s, deadline_s);
  }
}

TEST(ComputeReach, IsEmptyFromAForbiddenCellAndFromOutsideTheGrid) {
  TestFlowWorld sea(UniformFlow(TestGrid(), 0, 0));
  const auto count = [&](LonLat from) {
    return ComputeReach(sea.From(Glider(0.5), {from, 0, kDay_s})).cells.size();
  };
  EXPECT_GT(count({-90, 25}), 0u);
  EXPECT_EQ(0u, count({-80, 25}));
  sea.open[25 * 50 + 25] = 0;
  EXPECT_EQ(0u, count({-90, 25}));
}

TEST(Traverse, NeitherReachesNorFliesAVoyageThatMakesNoSense) {
  const TestFlowWorld sea(UniformFlow(TestGrid(), 0.1, 0.0));
  const LonLat from{-90, 25}, to{-89.9, 25};
  const VoyageRequest good = sea.From(Glider(0.5), {from, 0.0, kDay_s});
  ASSERT_TRUE(Traverse(good, ComputeReach(good), to));
  std::vector<VoyageRequest> bad(9, good);
  bad[0].departure.deadline_s = -1.0;
  bad[1].departure.deadline_s = HUGE_VAL;
  bad[2].departure.time_s = kGap;
  bad[3].departure.from.lat_deg = kGap;
  bad[4].departure.base_travel_m = kGap;
  bad[5].motion.cruise_mps = HUGE_VAL;
  bad[6].motion.boost_gain = kGap;
  const TestFlowWorld empty(VectorField{sea.field.grid, {}});
  bad[7].world.field = &empty.field;
  const kg_base::Mask small(7, 1);
  bad[8].world.open = &small;
  for (const VoyageRequest& voyage : bad) {
    EXPECT_FALSE(IsWellFormed(voyage));
    EXPECT_TRUE(ComputeReach(voyage).cells.empty());
    EXPECT_FALSE(Traverse(voyage, ComputeReach(good), to));
    EXPECT_FALSE(FlyTrack(voyage, {from, to}));
    EXPECT_TRUE(std::isinf(HoldableFrom_s(voyage, to)));
  }
  EXPECT_FALSE(FlyStretches(good, {{{from, to}, kGap}}));
  EXPECT_FALSE(FlyStretches(good, {{{from, to}, HUGE_VAL}}));
  EXPECT_FALSE(FlyStretches(good, {{{from, to}, -0.5}}));
}

// A later departure on the same track never arrives earlier.
TEST(FlyTrack, KeepsTheOrderOfDepartures) {
  std::mt19937 rng(37);
  int compared = 0;
  for (int round = 0; round < 30; ++round) {
    const TestFlowWorld sea(RandomFlow(rng, TestGrid(), 0.5, 7200, 2 * kDay_s));
    const LonLat from = sea.field.grid.Position({25, 25});
    const LonLat to =
        sea.field.grid.Position({Uniform(rng, 15, 35), Uniform(rng, 15, 35)});
    double last_s = 0.0;
    for (double start_s = 0; start_s < kDay_s; start_s += 3600) {
      const auto flight = FlyTrack(
          sea.From(Glider(0.6), {from, start_s, 3 * kDay_s}), {from, to});
      if (!flight) continue;
      const double arrival_s = start_s + flight->travel_s;
      EXPECT_GE(arrival_s, last_s - 1e-6);
      last_s = arrival_s;
      ++compared;
    }
  }
  EXPECT_GT(compared, 100);
}

TEST(FlyTrack, AddsUpEnergyThroughWaterHotelLoadAndHolding) {
  const TestFlowWorld sea(UniformFlow(TestGrid(), 0.2, 0.0));
  const auto flight = FlyTrack(sea.From(Glider(0.5), {{-90, 25}, 0, kDay_s}),
                               {{-90, 25}, {-89.8, 25}});
  ASSERT_TRUE(flight);
  const double t = kg_base::Distance_m({-90, 25}, {-89.8, 25}) / 0.7;
  const double through_m = 0.5 * t + 0.2 * (kDay_s - t);
  EXPECT_NEAR(t, flight->travel_s, 1.0);
  EXPECT_NEAR(through_m, flight->through_water_m, 1.0);
  EXPECT_NEAR(2.0 * through_m + 3.0 * kDay_s, flight->energy_j, 2.0);
  ASSERT_EQ(3u, flight->track.size());
  EXPECT_EQ(kDay_s, flight->track.back().time_s);
}

TEST(FlyTrack, TakesAtRestWhatCruisingTakesOfWhatHovers) {
  const TestFlowWorld sea(UniformFlow(TestGrid(), 0.2, 0.0));
  MotionModel motion = Glider(0.5);
  motion.rest_mps = motion.cruise_mps;
  const auto flight = FlyTrack(sea.From(motion, {{-90, 25}, 0, kDay_s}),
                               {{-90, 25}, {-89.8, 25}});
  ASSERT_TRUE(flight);
  EXPECT_NEAR(0.5 * kDay_s, flight->through_water_m, 1.0);
  EXPECT_NEAR(2.0 * 0.5 * kDay_s + 3.0 * kDay_s, flight->energy_j, 2.0);
  // A faster current determines the speed needed to hold station.
  const TestFlowWorld fast(UniformFlow(TestGrid(), 0.8, 0.0));
  const auto held =
      FlyTrack(fast.From(motion, {{-90, 25}, 0, kDay_s}), {{-90, 25}});
  ASSERT_TRUE(held);
  EXPECT_NEAR(0.8 * kDay_s, held->through_water_m, 1.0);
}

TEST(FlyTrack, IntegratesHazardUntilTheDeadline) {
  TestFlowWorld sea(UniformFlow(TestGrid(), 0.0, 0.0));
  kg_base::Raster attenuation(2500, 1.0f);
  for (int i = 0; i < 2500; ++i) attenuation[i] = i % 50 >= 27 ? 0.0f : 1.0f;
  sea.hazard =
      std::make_unique<HazardMap>(sea.field.grid, sea.open, attenuation, 10e3);
  const LonLat from = sea.field.grid.Centre({25, 25});
  const LonLat to = sea.field.grid.Centre({25, 29});
  const auto flight =
      FlyTrack(sea.From(Glider(0.5), {from, 0, kDay_s}), {from, to});
  ASSERT_TRUE(flight);
  // 1.5 of 4 cells are without hazard.
  const double calm_s = flight->travel_s * 1.5 / 4;
  EXPECT_NEAR(kDay_s - calm_s, flight->hazard_s, 0.03 * flight->travel_s);
}

TEST(FlyTrack, RefusesWhereStationCannotBeHeldUntilTheDeadline) {
  VectorField field = UniformFlow(TestGrid(), 0.2, 0.0);
  field.slices.push_back(field.slices[0]);
  field.slices[1].time_s = kDay_s;
  for (float& u : field.slices[1].east_mps) u = 1.0f;
  const TestFlowWorld sea(field);
  MotionModel motion = Glider(0.5);
  motion.max_mps = 0.9;
  const std::vector<LonLat> stay = {{-90, 25}};
  EXPECT_FALSE(FlyTrack(sea.From(motion, {{-90, 25}, 0, kDay_s}), stay));
  EXPECT_TRUE(FlyTrack(sea.From(motion, {{-90, 25}, 0, kDay_s / 2}), stay));
  motion.boost_gain = 0.5;
  EXPECT_TRUE(FlyTrack(sea.From(motion, {{-90, 25}, 0, kDay_s}), stay));
}

TEST(FlyTrack, StopsWhereTheBaseTravelIsUsedUp) {
  const TestFlowWorld sea(UniformFlow(TestGrid(), 0, 0));
  const LonLat from{-90, 25}, to{-89.9, 25};
  const double d = kg_base::Distance_m(from, to);
  EXPECT_TRUE(FlyTrack(sea.From(Glider(0.5), {from, 0, kDay_s, 1.001 * d}),
                       {from, to}));
  EXPECT_FALSE(
      FlyTrack(sea.From(Glider(0.5), {from, 0, kDay_s, 0.99 * d}), {from, to}));
}

// Three tracks of random places, each with its own speed.
std::vector<TrackStretch> RandomStretches(std::mt19937& rng,
                                          const kg_base::Grid& grid,
                                          LonLat from) {
  std::vector<TrackStretch> stretches;
  for (int i = 0; i < 3; ++i) {
    const LonLat middle =
        grid.Position({Uniform(rng, 20, 30), Uniform(rng, 20, 30)});
    const LonLat to =
        grid.Position({Uniform(rng, 20, 30), Uniform(rng, 20, 30)});
    stretches.push_back({{from, middle, to}, Uniform(rng, 0.8, 1.4)});
    from = to;
  }
  return stretches;
}

TEST(FlyStretches, IsEveryTrackFlownFromWhereAndWhenTheOneBeforeEnds) {
  std::mt19937 rng(51);
  int flown = 0;
  for (int round = 0; round < 40; ++round) {
    const TestFlowWorld sea(RandomFlow(rng, TestGrid(), 0.4, 7200, 3 * kDay_s));
    const LonLat from = sea.field.grid.Position({25, 25});
    const auto stretches = RandomStretches(rng, sea.field.grid, from);
    const auto flight =
        FlyStretches(sea.From(Glider(1.0), {from, 0.0, 2 * kDay_s}), stretches);
    double at_s = 0.0, through_m = 0.0, energy_j = 0.0;
    bool feasible = true;
    for (const TrackStretch& stretch : stretches) {
      const auto leg =
          FlyTrack(sea.From(Glider(stretch.speed_mps),
                            {stretch.via.front(), at_s, 2 * kDay_s}),
                   stretch.via);
      feasible = feasible && leg;
      if (!feasible) break;
      at_s += leg->travel_s;
      through_m += stretch.speed_mps * leg->travel_s;
      // The last stretch holds station; its energy is added.
      energy_j = leg->through_water_m - stretch.speed_mps * leg->travel_s;
    }
    ASSERT_EQ(feasible, flight.has_value());
    if (!flight) continue;
    EXPECT_NEAR(at_s, flight->travel_s, 1e-6 * at_s);
    EXPECT_NEAR(through_m / at_s, flight->speed_mps, 1e-6);
    EXPECT_NEAR(through_m + energy_j, flight->through_water_m,
                1e-3 * through_m);
    EXPECT_EQ(flight->track.back().time_s, 2 * kDay_s);
    ++flown;
  }
  EXPECT_GT(flown, 20);
}

TEST(FlyStretches, OneIsATrack) {
  std::mt19937 rng(52);
  const TestFlowWorld sea(RandomFlow(rng, TestGrid(), 0.4, 7200, kDay_s));
  const LonLat from{-90, 25};
  const std::vector<LonLat> via = {from, {-89.9, 25.05}, {-89.8, 25.0}};
  const VoyageRequest voyage = sea.From(Glider(0.9), {from, 0.0, kDay_s});
  const auto track = FlyTrack(voyage, via);
  const auto stretch = FlyStretches(voyage, {{via, 0.9}});
  ASSERT_TRUE(track && stretch);
  EXPECT_EQ(track->travel_s, stretch->travel_s);
  EXPECT_EQ(track->energy_j, stretch->energy_j);
  EXPECT_EQ(track->through_water_m, stretch->through_water_m);
  EXPECT_EQ(track->speed_mps, stretch->speed_mps);
}

TEST(FlyStretches, ShareTheBaseTravel) {
  const TestFlowWorld sea(UniformFlow(TestGrid(), 0, 0));
  const LonLat from{-90, 25}, middle{-89.9, 25}, to{-89.8, 25};
  const std::vector<TrackStretch> both = {{{from, middle}, 1.0},
                                          {{middle, to}, 0.5}};
  const double d =
      kg_base::Distance_m(from, middle) + kg_base::Distance_m(middle, to);
  EXPECT_TRUE(
      FlyStretches(sea.From(Glider(1.0), {from, 0, kDay_s, 1.001 * d}), both));
  EXPECT_FALSE(
      FlyStretches(sea.From(Glider(1.0), {from, 0, kDay_s, 0.99 * d}), both));
  EXPECT_FALSE(FlyStretches(sea.From(Glider(1.0), {from, 0, 29e3}), both));
}

TEST(FlyStretches, BeginWhereTheOneBeforeEnds) {
  const TestFlowWorld sea(UniformFlow(TestGrid(), 0, 0));
  const VoyageRequest voyage = sea.From(Glider(1.0), {{-90, 25}, 0, kDay_s});
  EXPECT_THROW(FlyStretches(voyage, {}), std::logic_error);
  EXPECT_THROW(FlyStretches(voyage, {{{{-90, 25}, {-89.9, 25}}, 1.0},
                                     {{{-89.8, 25}, {-89.7, 25}}, 1.0}}),
               std::logic_error);
}

TEST(FlyTrack, FeelsNoCurrentWithoutBoost) {
  const TestFlowWorld sea(UniformFlow(TestGrid(), 2.0, 0.0));
  MotionModel motion = Glider(0.5);
  motion.boost_gain = 0.0;
  const auto flight = FlyTrack(sea.From(motion, {{-90, 25}, 0, kDay_s}),
                               {{-90, 25}, {-90.1, 25}});
  ASSERT_TRUE(flight);
  EXPECT_NEAR(kg_base::Distance_m({-90, 25}, {-90.1, 25}) / 0.5,
              flight->travel_s, 1.0);
}

TEST(FlyTrack, RefusesLandTheGridsOutsideAndATrackFromElsewhere) {
  TestFlowWorld sea(UniformFlow(TestGrid(), 0, 0));
  sea.field.slices[0].east_mps[25 * 50 + 28] = kGap;
  const VoyageDeparture departure{sea.field.grid.Centre({25, 25}), 0, kDay_s};
  const MotionModel motion = Glider(0.5);
  EXPECT_FALSE(FlyTrack(sea.From(motion, departure),
                        {departure.from, sea.field.grid.Centre({25, 30})}));
  EXPECT_FALSE(
      FlyTrack(sea.From(motion, departure), {departure.from, {-80, 25}}));
  EXPECT_THROW(FlyTrack(sea.From(motion, departure), {{-90.5, 25}}),
               std::logic_error);
  EXPECT_THROW(FlyTrack(sea.From(motion, departure), {}), std::logic_error);
}

TEST(HoldableFrom, IsTheLastMomentTheCurrentIsTooStrong) {
  std::mt19937 rng(38);
  int inside = 0;
  for (int round = 0; round < 60; ++round) {
    const TestFlowWorld sea(
        RandomFlow(rng, EvenGrid(-91, 24, 0.04, 10, 10), 1.0, 7200, kDay_s));
    MotionModel motion = Glider(0.5);
    motion.max_mps = Uniform(rng, 0.2, 1.0);
    const LonLat place =
        sea.field.grid.Position({Uniform(rng, 0, 9), Uniform(rng, 0, 9)});
    double wanted = 0.0;
    for (double t = 0; t <= kDay_s; t += 30) {
      const auto c = sea.field.Sample(*sea.field.grid.Locate(place), t);
      if (std::hypot(c->east_mps, c->north_mps) > motion.max_mps) {
        wanted = t + 30;
      }
    }
    const double got =
        HoldableFrom_s(sea.From(motion, {place, 0, kDay_s}), place);
    if (wanted > kDay_s) {
      EXPECT_TRUE(std::isinf(got));
    } else {
      EXPECT_NEAR(wanted, got, 31.0);
      inside += wanted > 0;
    }
  }
  EXPECT_GT(inside, 5);
}

// Cells outside the read box of a reach may change without effect.
TEST(ComputeReach, ReadsNothingOutsideOfItsBoxNorDoItsFlights) {
  std::mt19937 rng(39);
  int flown = 0, inside = 0;
  for (int round = 0; round < 16; ++round) {
    TestFlowWorld sea(
        RandomFlow(rng, TestGrid(), round % 2 ? 0.3 : 0.9, 10800, kDay_s));
    sea.open = RandomMask(rng, sea.field.grid.size(), 0.97);
    VoyageRequest voyage = sea.From(
        Glider(0.3),
        {sea.field.grid.Position({Uniform(rng, 15, 35), Uniform(rng, 15, 35)}),
         0.0, 0.4 * kDay_s});
    if (round % 4 == 0) voyage.price = {1e-5, 1e-6, 0.0};
    const ReachMap reach = ComputeReach(voyage);
    TestFlowWorld other(sea.field);
    other.open = sea.open;
    for (int i = 0; i < static_cast<int>(other.open.size()); ++i) {
      if (Holds(reach.read, {i / 50, i % 50})) {
        ++inside;
        continue;
      }
      other.open[i] = Uniform(rng, 0, 1) < 0.5;
      for (kg_base::FieldSlice& slice : other.field.slices) {
        slice.east_mps[i] =
            round % 3 ? static_cast<float>(Uniform(rng, -2, 2)) : kGap;
      }
    }
    VoyageRequest elsewhere = voyage;
    elsewhere.world = {&other.field, &other.open, nullptr};
    const ReachMap again = ComputeReach(elsewhere);
    ASSERT_EQ(reach.cells.size(), again.cells.size());
    for (std::size_t i = 0; i < reach.cells.size(); ++i) {
      ASSERT_EQ(reach.cells[i].index, again.cells[i].index);
      ASSERT_EQ(reach.cells[i].arrival_s, again.cells[i].arrival_s);
    }
    for (int k = 0; k < 25; ++k) {
      if (reach.cells.empty()) break;
      const int index = reach.cells[rng() % reach.cells.size()].index;
      const LonLat to =
          sea.field.grid.Position({index / 50 + Uniform(rng, -0.5, 0.5),
                                   index % 50 + Uniform(rng, -0.5, 0.5)});
      const auto a = Traverse(voyage, reach, to);
      const auto b = Traverse(elsewhere, reach, to);
      ASSERT_EQ(a.has_value(), b.has_value());
      if (!a) continue;
      ++flown;
      ASSERT_EQ(a->travel_s, b->travel_s);
      ASSERT_EQ(a->energy_j, b->energy_j);
      ASSERT_EQ(a->track.size(), b->track.size());
    }
  }
  EXPECT_GT(flown, 20);
  EXPECT_GT(inside, 1000);
}

// |D/T - c| is the least speed through water that reaches D by T in a steady
// uniform current; arriving at T leaves no time to hold station.
TEST(Traverse, SpendsTheLeastEnergyThatAUniformCurrentAsksFor) {
  std::mt19937 rng(40);
  int flown = 0;
  for (int round = 0; round < 60; ++round) {
    const double east = Uniform(rng, -0.4, 0.4),
                 north = Uniform(rng, -0.4, 0.4);
    const TestFlowWorld sea(UniformFlow(TestGrid(), east, north));
    const LonLat from{-90.0, 25.0};
    const double bearing = Uniform(rng, 0, 2 * kg_base::kPi);
    const double d = Uniform(rng, 5e3, 30e3);
    const LonLat to = kg_base::Destination(from, bearing, d);
    const double least_mps = std::hypot(d * std::sin(bearing) / kDay_s - east,
                                        d * std::cos(bearing) / kDay_s - north);
    if (!(least_mps > 0.05 && least_mps < 0.48)) continue;
    // Otherwise that speed arrives before T and the current carries past D.
    const double x = d * std::sin(bearing), y = d * std::cos(bearing);
    if (!(x * (x / kDay_s - east) + y * (y / kDay_s - north) > 0.0)) continue;
    VoyageRequest voyage = sea.From(Glider(0.5), {from, 0.0, kDay_s});
    const auto fastest = Traverse(voyage, ComputeReach(voyage), to);
    voyage.price.per_j = 1.0;
    const auto cheapest = Traverse(voyage, ComputeReach(voyage), to);
    ASSERT_TRUE(cheapest);
    const double hotel_j = 3.0 * kDay_s, least_j = 2.0 * least_mps * kDay_s;
    EXPECT_GE(cheapest->energy_j - hotel_j, 0.999 * least_j);
    EXPECT_LE(cheapest->energy_j - hotel_j, 1.05 * least_j);
    EXPECT_LT(cheapest->speed_mps, 0.5);
    if (fastest) {
      EXPECT_EQ(0.5, fastest->speed_mps);
      EXPECT_LE(cheapest->energy_j, fastest->energy_j);
      EXPECT_LE(fastest->travel_s, cheapest->travel_s);
    }
    ++flown;
  }
  EXPECT_GT(flown, 6);
}

TEST(Traverse, DriftsWhereTheCurrentGoesAnyway) {
  const TestFlowWorld sea(UniformFlow(TestGrid(), 0.3, 0.1));
  const LonLat from{-90.6, 24.6};
  const kg_base::DegreesPerMetre scale = kg_base::LocalScale(24.65);
  const LonLat to{from.lon_deg + 0.3 * kDay_s * scale.lon_deg,
                  from.lat_deg + 0.1 * kDay_s * scale.lat_deg};
  VoyageRequest voyage = sea.From(Glider(0.5), {from, 0.0, kDay_s});
  voyage.price.per_j = 1.0;
  const auto flight = Traverse(voyage, ComputeReach(voyage), to);
  ASSERT_TRUE(flight);
  EXPECT_LT(flight->energy_j - 3.0 * kDay_s, 0.1 * 2.0 * 0.316 * kDay_s);
  EXPECT_LT(flight->speed_mps, 0.05);
}

// The flight chosen never costs more than the fastest one.
TEST(Traverse, ChoosesByThePrice) {
  std::mt19937 rng(41);
  int slower = 0, asked = 0;
  for (int round = 0; round < 8; ++round) {
    const TestFlowWorld sea(RandomFlow(rng, TestGrid(), 0.5, 7200, kDay_s));
    const LonLat from = sea.field.grid.Position({25, 25});
    const VoyageRequest fast = sea.From(Glider(0.5), {from, 0.0, kDay_s});
    VoyageRequest priced = fast;
    priced.price = {Uniform(rng, 0, 5e-6), 1e-5, 0.0};
    const ReachMap fast_reach = ComputeReach(fast),
                   reach = ComputeReach(priced);
    const auto cost = [&](const FlownPath& f) {
      return priced.price.per_s * f.travel_s + priced.price.per_j * f.energy_j;
    };
    for (int k = 0; k < 6; ++k) {
      const LonLat to =
          sea.field.grid.Position({Uniform(rng, 18, 32), Uniform(rng, 18, 32)});
      const auto a = Traverse(fast, fast_reach, to);
      const auto b = Traverse(priced, reach, to);
      if (!a) continue;
      ASSERT_TRUE(b);
      EXPECT_LE(cost(*b), cost(*a));
      slower += b->speed_mps < 0.5;
      ++asked;
      MotionModel motion = fast.motion;
      motion.cruise_mps = b->speed_mps;
      const auto again = Refly(sea, motion).Fly(*b);
      ASSERT_TRUE(again);
      EXPECT_NEAR(1.0, b->travel_s / *again, 0.005);
    }
  }
  EXPECT_GT(asked, 20);
  EXPECT_GT(slower, 5);
}

}  // namespace
}  // namespace kg_compiler
