#include "kg_selector/paths/churn.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "kg_base/geo/geodesy.h"

namespace kg_selector {
namespace {

using kg_compiler::SeamRules;

// Share of the weight charged at a distance.
double Share(const SeamRules& rules, double distance_m) {
  const double spacing_m =
      rules.spacing_m > 0.0 ? rules.spacing_m : rules.sensor_radius_m;
  if (distance_m < spacing_m) return distance_m / spacing_m;
  return distance_m > 0.0 ? 1.0 : 0.0;
}

}  // namespace

double ChurnCost(const SeamRules& rules, const int window,
                 const kg_base::LonLat& place) {
  if (!(rules.churn_weight > 0.0)) return 0.0;
  for (const kg_compiler::WindowRules& known : rules.windows) {
    if (known.window != window || !known.committed) continue;
    return rules.churn_weight *
           Share(rules, kg_base::Distance_m(*known.committed, place));
  }
  return 0.0;
}

void AddChurn(const SeamRules& rules, const kg_compiler::NavGraphs& graphs,
              kg_planner::Trellis* trellis) {
  for (std::size_t s = 0; s < graphs.size(); ++s) {
    std::vector<double> costs;
    for (const kg_compiler::Waypoint& waypoint : graphs[s].waypoints) {
      costs.push_back(ChurnCost(rules, graphs[s].window, waypoint.position));
    }
    for (kg_planner::Seam& seam : trellis->stages[s].seams) {
      seam.cost += costs.at(seam.to);
    }
  }
}

}  // namespace kg_selector
