// Random hostile voyages through all of the traversal: no input ends the
// program, and whatever is flown is a possible flight. A few thousand flights;
// KG_FLIGHTS sets another number, e.g. 100000 under the sanitizers:
//
//     KG_FLIGHTS=100000 scripts/sanitize.sh kg_compiler

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

#include "kg_compiler/traversal/sight.h"
#include "kg_compiler/traversal/testing/random_voyage.h"
#include "kg_compiler/traversal/traversal.h"

namespace kg_compiler {
namespace {

using kg_base::LonLat;

constexpr int kFewFlights = 2500;
constexpr int kTargets = 8;  // Per voyage.

int CountFlights() {
  const char* text = std::getenv("KG_FLIGHTS");
  return text != nullptr ? std::atoi(text) : kFewFlights;
}

void CheckReach(const VoyageRequest& voyage, const ReachMap& reach) {
  const kg_base::Grid& grid = voyage.world.field->grid;
  const double whole_s = voyage.departure.deadline_s - voyage.departure.time_s;
  for (const ReachedCell& cell : reach.cells) {
    ASSERT_GE(cell.index, 0);
    ASSERT_LT(cell.index, static_cast<int>(grid.size()));
    ASSERT_EQ(1, (*voyage.world.open)[cell.index]);
    ASSERT_TRUE(std::isfinite(cell.arrival_s));
    ASSERT_LE(cell.arrival_s, whole_s);
    ASSERT_GE(cell.root, 0);
    ASSERT_LT(cell.root, static_cast<int>(reach.roots.size()));
  }
  for (const ReachRoot& root : reach.roots) {
    ASSERT_TRUE(grid.Locate(grid.Position(root.place)));
    ASSERT_TRUE(std::isfinite(root.time_s + root.heading_rad));
  }
}

// In open water with a known current, on the grid.
bool IsInOpenWater(const TraversalWorld& world, const TimedPoint& point) {
  const kg_base::Grid& grid = world.field->grid;
  const auto at = grid.Locate(point.position);
  return at && (*world.open)[grid.Index(CellOf(grid, *at))] == 1 &&
         world.field->Sample(*at, point.time_s);
}

void CheckFlight(const VoyageRequest& voyage, LonLat to,
                 const FlownPath& flight) {
  const VoyageDeparture& departure = voyage.departure;
  ASSERT_FALSE(flight.track.empty());
  EXPECT_EQ(departure.from, flight.track.front().position);
  EXPECT_EQ(departure.time_s, flight.track.front().time_s);
  EXPECT_EQ(to, flight.track.back().position);
  double last_s = departure.time_s;
  for (const TimedPoint& point : flight.track) {
    ASSERT_GE(point.time_s, last_s);
    ASSERT_LE(point.time_s, departure.deadline_s);
    ASSERT_TRUE(IsInOpenWater(voyage.world, point));
    last_s = point.time_s;
  }
  for (const double figure : {flight.travel_s, flight.energy_j, flight.hazard_s,
                              flight.through_water_m, flight.speed_mps}) {
    ASSERT_TRUE(std::isfinite(figure));
    ASSERT_GE(figure, 0.0);
  }
  EXPECT_LE(flight.travel_s, departure.deadline_s - departure.time_s);
}

// A target of the voyage: half of them in reach.
LonLat MakeTarget(RandomVoyages* random, const kg_base::Grid& grid,
                  const ReachMap& reach) {
  if (reach.cells.empty() || random->Chance(0.5)) {
    return random->MakePlace(grid);
  }
  const int index = reach.cells[random->Pick(reach.cells.size())].index;
  return grid.Centre({index / grid.cols(), index % grid.cols()});
}

// Flies one voyage to several targets; returns the number of flights found.
int FlyVoyage(RandomVoyages* random, const TestFlowWorld& world) {
  const kg_base::Grid& grid = world.field.grid;
  const VoyageRequest voyage = random->MakeVoyage(world);
  const ReachMap reach = ComputeReach(voyage);
  CheckReach(voyage, reach);
  int flown = 0;
  for (int k = 0; k < kTargets; ++k) {
    const LonLat to = MakeTarget(random, grid, reach);
    const auto flight = Traverse(voyage, reach, to);
    if (flight) CheckFlight(voyage, to, *flight);
    flown += flight.has_value();
    EXPECT_FALSE(std::isnan(HoldableFrom_s(voyage, to)));
    if (::testing::Test::HasFailure()) return flown;
  }
  // A walk of two stretches at speeds of their own.
  const LonLat from = voyage.departure.from, middle = random->MakePlace(grid),
               to = random->MakePlace(grid);
  if (!(from == from && middle == middle)) return flown;  // NaN joins nothing.
  const auto walk = FlyStretches(voyage, {{{from, middle}, random->MakeSpeed()},
                                          {{middle, to}, random->MakeSpeed()}});
  if (walk) CheckFlight(voyage, to, *walk);
  return flown + walk.has_value();
}

TEST(RandomFlights, ArePossibleOrNotFlownInMadeWorlds) {
  const int flights = CountFlights();
  int asked = 0, flown = 0;
  for (unsigned seed = 1; asked < flights; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RandomVoyages random(seed);
    const TestFlowWorld world = random.MakeWorld();
    for (int round = 0; round < 4; ++round, asked += kTargets + 1) {
      flown += FlyVoyage(&random, world);
      if (HasFailure()) return;
    }
  }
  EXPECT_GT(flown, asked / 10);
  RecordProperty("flown", flown);
}

TEST(RandomFlights, ArePossibleOrNotFlownInRealCurrents) {
  const int flights = CountFlights() / 10;
  int worlds = 0;
  for (const char* file : kRealFiles) {
    std::optional<TestFlowWorld> world = RealSea(file);
    if (!world) continue;
    ++worlds;
    int asked = 0, flown = 0;
    for (unsigned seed = 1; asked < flights; ++seed, asked += kTargets + 1) {
      SCOPED_TRACE(file + (", seed " + std::to_string(seed)));
      RandomVoyages random(seed);
      flown += FlyVoyage(&random, *world);
      if (HasFailure()) return;
    }
    EXPECT_GT(flown, asked / 10);
  }
  if (worlds == 0) GTEST_SKIP() << "no real currents: set KG_SHARED_DATA";
}

}  // namespace
}  // namespace kg_compiler
