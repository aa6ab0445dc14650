// The terms of a seam's cost S, one row each:
//
//   S = sum over the terms of weight * quantity          [reward units]
//
//   term         weight                quantity
//   time         lambda_time           t, travel time [s]
//   energy       lambda_energy         E [J]
//   risk         lambda_risk           H + I [s], hazard and isolation
//   uncertainty  lambda_unc            1 - w of the window one arrives in
//   wave_height  lambda_waveHeight     X, integral over the flight [m s]
//   ...          likewise for every kg_core::CostQuantities()
//
// S is summed, hashed (HashWeights) and explained in loops over the rows. A new
// term is a row here, if its quantity is in the edge; one of a further field is
// a row of kg_core's source_quantities.cc and nothing here.

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
  std::string unit;    // Of the quantity.
  std::function<double(const SeamWeights&)> weight;
  // Of an edge into a window of confidence w.
  std::function<double(const TraverseEdge&, double confidence)> quantity;
  // The facts that it rests on, by the properties that say them.
  std::vector<std::string> policy_properties;
  std::string field;         // The kg_core::SourceQuantity, if it is of one.
  bool is_optional = false;  // Absent (no bit changes) where its weight is 0.

  double Cost(const SeamWeights& weights, const TraverseEdge& edge,
              double confidence) const {
    return weight(weights) * quantity(edge, confidence);
  }
};

// In the order in which they are summed.
const std::vector<SeamTerm>& SeamTerms();

// S of an edge into a window of confidence w, in reward units.
double SeamCost(const SeamWeights& weights, const TraverseEdge& edge,
                double confidence);

}  // namespace kg_compiler

#endif  // KG_COMPILER_CONTROL_PLANE_SEAM_COST_H_
