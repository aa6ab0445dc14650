// Cost of one traverse edge for one agent (ex:EdgeCost), computed from the
// flown path and the terms of the edge's window.

#ifndef KG_COMPILER_CONTROL_PLANE_EDGE_COST_H_
#define KG_COMPILER_CONTROL_PLANE_EDGE_COST_H_

#include <vector>

#include "kg_compiler/control_plane/waypoint_graph.h"
#include "kg_compiler/traversal/traversal.h"

namespace kg_compiler {

struct EdgeCost {
  double travel_s = 0.0;         // Departure to arrival.
  double energy_j = 0.0;         // Propulsion, holding station, hotel load.
  double hazard_s = 0.0;         // Hazard in [0, 1] integrated over time.
  double isolation_s = 0.0;      // I: having few alternative places.
  double through_water_m = 0.0;  // Distance through water.
  double speed_mps = 0.0;        // Through water until the arrival.
  // Time integrals of the cost fields along the edge [unit s]; empty = no
  // field.
  std::vector<double> exposures = {};
  double turn_rad = 0.0;   // T: turn from the start heading, in [0, pi].
  double seam_cost = 0.0;  // S, reward units.
};

// Costs that follow from the flight alone; all others are 0.
inline EdgeCost CostOfFlight(const FlownPath& flight) {
  EdgeCost cost;
  cost.travel_s = flight.travel_s;
  cost.energy_j = flight.energy_j;
  cost.hazard_s = flight.hazard_s;
  cost.through_water_m = flight.through_water_m;
  cost.speed_mps = flight.speed_mps;
  return cost;
}

inline EdgeCost CostOfEdge(const TraverseEdge& edge) {
  EdgeCost cost = CostOfFlight(edge.flight);
  cost.isolation_s = edge.isolation_s;
  cost.exposures = edge.exposures;
  cost.turn_rad = edge.turn_rad;
  cost.seam_cost = edge.seam_cost;
  return cost;
}

// Exact comparison; NaN differs from everything.
inline bool operator==(const EdgeCost& a, const EdgeCost& b) {
  return a.travel_s == b.travel_s && a.energy_j == b.energy_j &&
         a.hazard_s == b.hazard_s && a.isolation_s == b.isolation_s &&
         a.through_water_m == b.through_water_m && a.speed_mps == b.speed_mps &&
         a.exposures == b.exposures && a.turn_rad == b.turn_rad &&
         a.seam_cost == b.seam_cost;
}

}  // namespace kg_compiler

#endif  // KG_COMPILER_CONTROL_PLANE_EDGE_COST_H_
