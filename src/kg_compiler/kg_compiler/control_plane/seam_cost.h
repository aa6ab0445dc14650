// The terms of a seam's cost S, one row each:
//
//   S = sum over the terms of weight * quantity          [reward units]
//
//   term         weight                quantity
//   time         lambda_time           t, travel time [s]
//   energy       lambda_energy         E [J]
//   risk         lambda_risk           H + I [s], hazard and isolation
//   uncertainty  lambda_unc            1 - w of the window of arrival
//   turn         lambda_turn           T [rad], from the start heading
//   wave_height  lambda_waveHeight     X, integral over the flight [m s]
//   ...          likewise for every kg_mission::CostQuantities()
//
// S is summed, hashed (HashWeights) and explained in loops over the rows. To
// add a term whose quantity is stored in the edge, add a row here; to add a
// term of a further field, add a row to kg_core's source_quantities.cc only.

#ifndef KG_COMPILER_CONTROL_PLANE_SEAM_COST_H_
#define KG_COMPILER_CONTROL_PLANE_SEAM_COST_H_

#include <functional>
#include <string>
#include <vector>

#include "kg_compiler/control_plane/seam_weights.h"
#include "kg_compiler/control_plane/waypoint_graph.h"

namespace kg_compiler {

struct SeamTerm {
  std::string name;
  std::string symbol;  // "lambda_time * t".
  std::string unit;    // Unit of the quantity.
  std::function<double(const SeamWeights&)> weight;
  // Quantity of an edge into a window of the given confidence w.
  std::function<double(const TraverseEdge&, double confidence)> quantity;
  // Properties of the policy facts that define the weight.
  std::vector<std::string> policy_properties;
  std::string field;  // Name of its kg_mission::SourceQuantity; may be empty.
  bool is_optional = false;  // Omitted from sum and hash if its weight is 0.

  double Cost(const SeamWeights& weights, const TraverseEdge& edge,
              double confidence) const {
    return weight(weights) * quantity(edge, confidence);
  }
};

// All terms in the order of summation.
const std::vector<SeamTerm>& SeamTerms();

// S of an edge into a window of confidence w, in reward units.
double SeamCost(const SeamWeights& weights, const TraverseEdge& edge,
                double confidence);

}  // namespace kg_compiler

#endif  // KG_COMPILER_CONTROL_PLANE_SEAM_COST_H_
