// One agent's proposal for the whole horizon, as the selector weighs it.

#ifndef KG_SELECTOR_PATHLET_H_
#define KG_SELECTOR_PATHLET_H_

#include <optional>
#include <string>
#include <vector>

#include "kg_compiler/traversal.h"
#include "kg_core/geo/lon_lat.h"

namespace kg_selector {

struct Visit {
  int window = 0;
  int waypoint = 0;  // Id in the agent's NavGraph of that window.
  kg_core::LonLat position;
  double reward = 0.0;
  std::vector<std::string> events;  // IRIs of events this visit counts for.
};

struct Pathlet {
  std::string agent;  // IRI.
  int rank = 0;       // In the agent's own order, 0 = best.
  double reward = 0.0;
  double seam_cost = 0.0;
  std::vector<Visit> visits;                   // One a window, ascending.
  std::vector<kg_compiler::TimedPoint> track;  // Where it is when.
  double score() const { return reward - seam_cost; }
};

// Closest approach of two tracks while both exist [m]; straight and steady
// between points. Nothing if they never exist at the same time.
struct Approach {
  double distance_m = 0.0;
  double time_s = 0.0;
};
std::optional<Approach> ClosestApproach(
    const std::vector<kg_compiler::TimedPoint>& a,
    const std::vector<kg_compiler::TimedPoint>& b);

}  // namespace kg_selector

#endif  // KG_SELECTOR_PATHLET_H_
