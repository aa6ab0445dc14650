// Random voyages for robustness tests, made to be hostile: starts and targets
// on land, on the outer edges and off the grid; windows outside of the data;
// holes in single components and single slices; currents from none to far
// stronger than any vehicle; now and then a NaN or an infinity in any number.

#ifndef KG_COMPILER_TRAVERSAL_TESTING_RANDOM_VOYAGE_H_
#define KG_COMPILER_TRAVERSAL_TESTING_RANDOM_VOYAGE_H_

#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <memory>
#include <random>
#include <utility>
#include <vector>

#include "kg_compiler/testing/test_world.h"
#include "kg_compiler/traversal/testing/test_flow_world.h"

namespace kg_compiler {

class RandomVoyages {
 public:
  explicit RandomVoyages(unsigned seed) : rng_(seed) {}

  // A generated world: grid, currents with holes, mask, perhaps hazard.
  TestFlowWorld MakeWorld() {
    const kg_base::Grid grid = MakeGrid();
    TestFlowWorld world(MakeField(grid));
    MakeHoles(&world.field);
    MakeMask(&world);
    if (Chance(0.3)) {
      world.hazard = std::make_unique<HazardMap>(
          world.field.grid, world.open,
          RandomRaster(rng_, world.open.size(), 0.0, 1.5),
          Chance(0.2) ? 0.0 : Uniform(rng_, 1e3, 5e4));
    }
    return world;
  }

  VoyageRequest MakeVoyage(const TestFlowWorld& world) {
    VoyageRequest voyage = world.From(MakeMotion(), MakeDeparture(world.field));
    if (Chance(0.3)) voyage.price = {Uniform(rng_, 0, 1e-5), 1e-6, 0.0};
    if (Chance(0.1)) voyage.price.per_hazard_s = 1e-5;
    return voyage;
  }

  // Mostly a place on the grid; also its outer edges, outside, and NaN.
  kg_base::LonLat MakePlace(const kg_base::Grid& grid) {
    const double rows = grid.rows(), cols = grid.cols();
    kg_base::LonLat place = grid.Position(
        {Uniform(rng_, -0.5, rows - 0.5), Uniform(rng_, -0.5, cols - 0.5)});
    if (Chance(0.1)) {
      place = grid.Centre({static_cast<int>(rng_() % grid.rows()),
                           static_cast<int>(rng_() % grid.cols())});
    }
    if (Chance(0.1)) {
      place.lon_deg = Chance(0.5) ? grid.west_deg() : grid.east_deg();
    }
    if (Chance(0.1)) {
      place.lat_deg = Chance(0.5) ? grid.south_deg() : grid.north_deg();
    }
    if (Chance(0.02)) place.lon_deg = Spoil(place.lon_deg + 360.0);
    if (Chance(0.02)) place.lat_deg = Spoil(place.lat_deg + 1.0);
    return place;
  }

  // A speed [m/s]; now and then one that makes no sense.
  double MakeSpeed() {
    const double speed_mps =
        Chance(0.05) ? Uniform(rng_, 10, 300) : Uniform(rng_, 0.05, 2.0);
    return Chance(0.02) ? Spoil(speed_mps) : speed_mps;
  }

  bool Chance(double share) { return Uniform(rng_, 0, 1) < share; }
  std::size_t Pick(std::size_t count) { return rng_() % count; }

 private:
  // The value itself, or one that no real quantity has.
  double Spoil(double value) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const double values[] = {value,  0.0,        -value,     NAN,
                             1e300,  -1e300,     kInfinity,  -kInfinity,
                             1e-300, 2147483648, -2147483649};
    return values[Pick(std::size(values))];
  }

  kg_base::Grid MakeGrid() {
    const int rows = static_cast<int>(Uniform(rng_, 2, 41));
    const int cols = static_cast<int>(Uniform(rng_, 2, 41));
    if (Chance(0.3)) return UnevenGrid(rng_, rows, cols);
    // Anywhere on Earth, up to the poles.
    const double step_deg = Chance(0.2) ? 0.001 : 0.04;
    return EvenGrid(Uniform(rng_, -180, 175), Uniform(rng_, -90, 88), step_deg,
                    rows, cols);
  }

  kg_base::VectorField MakeField(const kg_base::Grid& grid) {
    const double step_s = Uniform(rng_, 1800, 43200);
    const double end_s = Chance(0.3) ? 0.0 : 2 * kDay_s;
    const double speed_mps =
        Chance(0.04) ? Uniform(rng_, 10, 100) : Uniform(rng_, 0, 3);
    if (Chance(0.2)) {
      return UniformFlow(grid, Uniform(rng_, -speed_mps, speed_mps),
                         Uniform(rng_, -speed_mps, speed_mps));
    }
    kg_base::VectorField field =
        RandomFlow(rng_, grid, speed_mps, step_s, end_s);
    if (!Chance(0.2)) return field;
    // White noise: as rough as a field can be.
    for (kg_base::FieldSlice& slice : field.slices) {
      slice.east_mps = RandomRaster(rng_, grid.size(), -speed_mps, speed_mps);
      slice.north_mps = RandomRaster(rng_, grid.size(), -speed_mps, speed_mps);
    }
    return field;
  }

  void MakeHoles(kg_base::VectorField* field) {
    if (Chance(0.4)) return;
    const double share = Chance(0.2) ? 0.5 : 0.03;
    for (std::size_t i = 0; i < field->grid.size(); ++i) {
      if (!Chance(share)) continue;
      const bool everywhere = Chance(0.7);
      const std::size_t only = Pick(field->slices.size());
      for (std::size_t k = 0; k < field->slices.size(); ++k) {
        if (!everywhere && k != only) continue;
        if (everywhere || Chance(0.5)) field->slices[k].east_mps[i] = kGap;
        if (everywhere || Chance(0.5)) field->slices[k].north_mps[i] = kGap;
      }
    }
  }

  void MakeMask(TestFlowWorld* world) {
    const kg_base::Grid& grid = world->field.grid;
    if (Chance(0.5)) {
      world->open = RandomMask(rng_, grid.size(), Uniform(rng_, 0.6, 1.0));
    }
    if (!Chance(0.3)) return;
    // A coast across the grid.
    const double slope = Uniform(rng_, -2, 2);
    const double begin = Uniform(rng_, 0, grid.cols());
    for (int r = 0; r < grid.rows(); ++r) {
      for (int c = 0; c < grid.cols(); ++c) {
        if (c < begin + slope * r) world->open[grid.Index({r, c})] = 0;
      }
    }
  }

  MotionModel MakeMotion() {
    MotionModel motion;
    motion.cruise_mps = MakeSpeed();
    motion.max_mps = Chance(0.5) ? 1e5 : MakeSpeed();
    motion.boost_gain = Chance(0.7) ? 1.0 : Uniform(rng_, -0.5, 1.5);
    motion.energy_per_m_j = Uniform(rng_, 0, 5);
    motion.hotel_load_w = Uniform(rng_, 0, 5);
    if (Chance(0.1)) motion.rest_mps = motion.cruise_mps;
    if (Chance(0.01)) motion.boost_gain = Spoil(1.0);
    return motion;
  }

  VoyageDeparture MakeDeparture(const kg_base::VectorField& field) {
    VoyageDeparture departure;
    departure.from = MakePlace(field.grid);
    // From well before the first slice to well after the last.
    departure.time_s = Uniform(rng_, -kDay_s, 4 * kDay_s);
    if (Chance(0.2)) {
      departure.time_s = field.slices[Pick(field.slices.size())].time_s;
    }
    departure.deadline_s = departure.time_s + Uniform(rng_, 0, kDay_s);
    if (Chance(0.1)) departure.base_travel_m = Uniform(rng_, 0, 1e5);
    if (Chance(0.02)) departure.time_s = Spoil(departure.time_s);
    if (Chance(0.02)) departure.deadline_s = Spoil(departure.time_s);
    if (Chance(0.02)) departure.base_travel_m = Spoil(1000.0);
    return departure;
  }

  std::mt19937 rng_;
};

}  // namespace kg_compiler

#endif  // KG_COMPILER_TRAVERSAL_TESTING_RANDOM_VOYAGE_H_
