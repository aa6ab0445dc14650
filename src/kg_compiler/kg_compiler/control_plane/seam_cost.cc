#include "kg_compiler/control_plane/seam_cost.h"

namespace kg_compiler {

double SeamCost(const SeamWeights& weights, const TraverseEdge& edge,
                double confidence) {
  return weights.time_per_s * edge.flight.travel_s +
         weights.energy_per_j * edge.flight.energy_j +
         weights.risk_per_s * (edge.flight.hazard_s + edge.isolation_s) +
         weights.uncertainty * (1.0 - confidence);
}

}  // namespace kg_compiler
