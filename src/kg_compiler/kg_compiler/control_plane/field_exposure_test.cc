#include "kg_compiler/control_plane/field_exposure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "kg_compiler/control_plane/seam_cost.h"
#include "kg_compiler/testing/test_world.h"
#include "kg_mission/mission/source_quantities.h"

namespace kg_compiler {
namespace {

// Linear in longitude, latitude and time: f = 1 + 2 x + 3 y + 4 t / day, with x
// and y from the south-western centre [deg].
double Linear(kg_base::LonLat at, double time_s) {
  return 1.0 + 2.0 * (at.lon_deg + 91.0) + 3.0 * (at.lat_deg - 24.0) +
         4.0 * time_s / 86400.0;
}

kg_base::VectorField FieldWithWaves() {
  kg_base::VectorField field =
      UniformFlow(EvenGrid(-91, 24, 0.1, 20, 30), 0, 0);
  kg_base::ScalarField waves;
  waves.quantity = "wave_height";
  for (const double time_s : {0.0, 43200.0, 86400.0}) {
    kg_base::Raster values(field.grid.size());
    for (int row = 0; row < field.grid.rows(); ++row) {
      for (int col = 0; col < field.grid.cols(); ++col) {
        values[field.grid.Index({row, col})] =
            static_cast<float>(Linear(field.grid.Centre({row, col}), time_s));
      }
    }
    waves.slices.push_back({time_s, values});
  }
  field.scalars.push_back(waves);
  return field;
}

// Two legs, then at rest until the end of the day.
FlownPath TwoLegs() {
  FlownPath flight;
  flight.track = {{{-90.5, 24.5}, 0.0},
                  {{-89.5, 24.9}, 20000.0},
                  {{-89.2, 25.6}, 50000.0},
                  {{-89.2, 25.6}, 86400.0}};
  flight.travel_s = 50000.0;
  return flight;
}

TEST(FieldExposures, AreTheClosedFormOfALinearField) {
  const FlownPath flight = TwoLegs();
  double expected = 0.0;  // Trapezoids are exact along straight legs.
  for (std::size_t i = 1; i < 3; ++i) {
    const TimedPoint &a = flight.track[i - 1], &b = flight.track[i];
    expected += 0.5 *
                (Linear(a.position, a.time_s) + Linear(b.position, b.time_s)) *
                (b.time_s - a.time_s);
  }
  const std::vector<double> exposures =
      FieldExposures(FieldWithWaves(), flight);
  ASSERT_EQ(exposures.size(), kg_mission::CostQuantities().size());
  EXPECT_NEAR(exposures[0], expected, 1e-5 * expected);
}

TEST(FieldExposures, AreEmptyWithoutAFieldThatCosts) {
  kg_base::VectorField field = FieldWithWaves();
  field.scalars.clear();
  EXPECT_TRUE(FieldExposures(field, TwoLegs()).empty());
}

TEST(FieldExposures, CountUnknownValuesAsZero) {
  kg_base::VectorField field = FieldWithWaves();
  for (auto& slice : field.scalars[0].slices) {
    for (float& value : slice.values) {
      value = std::numeric_limits<float>::quiet_NaN();
    }
  }
  EXPECT_EQ(FieldExposures(field, TwoLegs())[0], 0.0);
}

TEST(SeamTerms, SumToTheSeamCostAndLeaveNoBitBehindWithoutAnOptionalWeight) {
  std::mt19937 rng(3);
  for (int i = 0; i < 200; ++i) {
    SeamWeights weights;
    weights.time_per_s = Uniform(rng, 0, 1e-4);
    weights.energy_per_j = Uniform(rng, 0, 1e-5);
    weights.risk_per_s = Uniform(rng, 0, 1e-4);
    weights.uncertainty = Uniform(rng, 0, 1);
    TraverseEdge edge;
    edge.flight.travel_s = Uniform(rng, 0, 86400);
    edge.flight.energy_j = Uniform(rng, 0, 1e6);
    edge.flight.hazard_s = Uniform(rng, 0, 86400);
    edge.isolation_s = Uniform(rng, 0, 1000);
    const double w = Uniform(rng, 0, 1);
    const double literal =
        weights.time_per_s * edge.flight.travel_s +
        weights.energy_per_j * edge.flight.energy_j +
        weights.risk_per_s * (edge.flight.hazard_s + edge.isolation_s) +
        weights.uncertainty * (1.0 - w);
    EXPECT_EQ(SeamCost(weights, edge, w), literal);
    edge.exposures = {Uniform(rng, 0, 1e5)};
    EXPECT_EQ(SeamCost(weights, edge, w), literal);
    weights.field_per_s = {1e-6};
    EXPECT_EQ(SeamCost(weights, edge, w), literal + 1e-6 * edge.exposures[0]);
    weights.field_per_s.clear();
    edge.turn_rad = Uniform(rng, 0, 3);
    EXPECT_EQ(SeamCost(weights, edge, w), literal);
    weights.turn_per_rad = 0.25;
    EXPECT_EQ(SeamCost(weights, edge, w), literal + 0.25 * edge.turn_rad);
  }
}

}  // namespace
}  // namespace kg_compiler
