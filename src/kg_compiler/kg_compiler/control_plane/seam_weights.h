// The weights of a seam's cost.

#ifndef KG_COMPILER_CONTROL_PLANE_SEAM_WEIGHTS_H_
#define KG_COMPILER_CONTROL_PLANE_SEAM_WEIGHTS_H_

#include <vector>

namespace kg_compiler {

// S = lambda_time t + lambda_energy E + lambda_risk (H + I)
//     + lambda_uncertainty (1 - w) + lambda_turn T
// with t [s], E [J], H the hazard integrated over time [s], I the isolation of
// the destination, over time [s] (nav_graph.h, A20), and w the confidence of
// the window of arrival (A55), and T the turn from the start heading [rad]
// (waypoint_graph.h). In reward units, >= 0. The lambdas are also the
// objective of the flight: a policy trades speed against energy.
struct SeamWeights {
  double time_per_s = 0.0;
  double energy_per_j = 0.0;
  double risk_per_s = 0.0;
  double uncertainty = 0.0;
  double isolation = 0.0;  // Hazard rate with no other waypoint near.
  // Weights of the cost fields (kg_mission's CostQuantities(), in their order),
  // per second and unit; empty = all 0. With X the integral of such a field
  // over the flight, S has a further term lambda_field X for each.
  std::vector<double> field_per_s = {};
  double turn_per_rad = 0.0;
};

}  // namespace kg_compiler

#endif  // KG_COMPILER_CONTROL_PLANE_SEAM_WEIGHTS_H_
