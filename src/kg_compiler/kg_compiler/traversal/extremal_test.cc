#include "kg_compiler/traversal/extremal.h"

#include <gtest/gtest.h>

#include "kg_compiler/testing/test_world.h"
#include "kg_compiler/traversal/testing/test_flow_world.h"

namespace kg_compiler {
namespace {

// Zermelo's heading equation, with angles and by Euler's method:
// d theta/dt = v_x sin^2 + (u_x - v_y) sin cos - u_y cos^2, theta from east
// (the convergence of meridians is negligible over a kilometre at 1 N).
TEST(ExtremalStepper, FollowsZermelosHeadingEquation) {
  const double deg = 0.0001;
  kg_base::VectorField field =
      UniformFlow(EvenGrid(-0.002, 0.0, deg, 40, 40), 0, 0);
  for (int r = 0; r < 40; ++r) {
    for (int c = 0; c < 40; ++c) {
      field.slices[0].east_mps[r * 40 + c] = 0.01f * c - 0.02f * r;
      field.slices[0].north_mps[r * 40 + c] = 0.015f * c + 0.005f * r;
    }
  }
  const TestFlowWorld sea(field);
  const VoyageRequest voyage =
      sea.From(Glider(1.0), {{0.0, 0.001}, 0.0, 1000.0});
  const FlowSampler flow(voyage);
  const ExtremalStepper helm(flow, 1.0);
  const kg_base::DegreesPerMetre scale = kg_base::LocalScale(0.002);
  const double cells_x = scale.lon_deg / deg, cells_y = scale.lat_deg / deg;
  for (double heading = 0.0; heading < 6.2; heading += 0.4) {
    ExtremalState at = SetOut(flow, {20.0, 20.0}, heading);
    double theta = heading, x = 20.0, y = 20.0;
    for (int i = 0; i < 40; ++i) {
      at = helm.Advance(at, ExtremalStepper::Step(flow, i, 1.0));
      for (int k = 0; k < 100; ++k) {
        const double s = std::sin(theta), c = std::cos(theta);
        const double ux = 0.01 * cells_x, uy = -0.02 * cells_y;
        const double vx = 0.015 * cells_x, vy = 0.005 * cells_y;
        const double u = 0.01 * x - 0.02 * y, v = 0.015 * x + 0.005 * y;
        x += 0.01 * (u + c) * cells_x;
        y += 0.01 * (v + s) * cells_y;
        theta += 0.01 * (vx * s * s + (ux - vy) * s * c - uy * c * c);
      }
    }
    EXPECT_NEAR(x, at.col, 0.01);
    EXPECT_NEAR(y, at.row, 0.01);
    EXPECT_NEAR(0.0, std::sin(theta - HeadingOf(flow, at)), 1e-3);
  }
}

// Fourth order where the field is smooth: half the step, 1/16 of the error.
TEST(ExtremalStepper, IsOfFourthOrderWithinAPatch) {
  std::mt19937 rng(4);
  kg_base::VectorField field = UniformFlow(EvenGrid(-91, 24, 1.0, 4, 4), 0, 0);
  for (int i = 0; i < 16; ++i) {
    field.slices[0].east_mps[i] = static_cast<float>(Uniform(rng, -1, 1));
    field.slices[0].north_mps[i] = static_cast<float>(Uniform(rng, -1, 1));
  }
  const TestFlowWorld sea(field);
  const VoyageRequest voyage =
      sea.From(Glider(1.0), {{-89.5, 25.5}, 0, kDay_s});
  const FlowSampler flow(voyage);
  const ExtremalStepper helm(flow, 1.0);
  const auto end = [&](int steps) {
    ExtremalState at = SetOut(flow, {1.5, 1.5}, 0.3);
    for (int i = 0; i < steps; ++i) {
      at = helm.Advance(at, ExtremalStepper::Step(flow, 20000.0 * i / steps,
                                                  20000.0 / steps));
    }
    return at;
  };
  const ExtremalState fine = end(64), two = end(2), four = end(4);
  const double coarse_error =
      std::hypot(two.col - fine.col, two.row - fine.row);
  const double error = std::hypot(four.col - fine.col, four.row - fine.row);
  EXPECT_LT(error, coarse_error / 8);
}

}  // namespace
}  // namespace kg_compiler
