// A plan as read from the store: every agent's stops and tracks, for the
// writers of export formats. Needs no node and no topic, so a plan can be
// exported after a restart.

#ifndef KG_ENGINE_EXPORT_PLAN_TRACKS_H_
#define KG_ENGINE_EXPORT_PLAN_TRACKS_H_

#include <string>
#include <vector>

#include "kg_base/geo/lon_lat.h"
#include "kg_core/rdf/graph_view.h"
#include "kg_engine/terms/track_literal.h"

namespace kg_engine {

// An ex:Assignment.
struct PlannedStop {
  int window = 0;  // ex:index.
  std::string window_iri;
  std::string status;        // "planned" or "executed".
  kg_base::LonLat position;  // At the end of the window.
  double time_s = 0.0;       // End time of its path [Unix s]; NaN = no path.
  double reward = 0.0;
  double seam_cost = 0.0;
  double travel_h = 0.0;            // ex:costHours.
  double energy_wh = 0.0;           // ex:costEnergy.
  double risk_h = 0.0;              // ex:costRisk.
  std::vector<std::string> events;  // IRIs.
};

struct PlannedAgent {
  std::string id;
  std::string iri;
  std::vector<PlannedStop> stops;  // Sorted by window.
  // The whole track, cut only at the antimeridian and at gaps without a path.
  std::vector<Track> parts;
};

struct PlanTracks {
  std::string run_iri;
  unsigned long long world_version = 0;
  std::string status;  // "ok", "stale", ...
  std::string mission_name;
  std::vector<PlannedAgent> agents;  // Sorted by id.
};

// Reads the plan graph with this IRI. Throws kg_base::InputError if it contains
// no plan.
PlanTracks ReadPlanTracks(const kg_core::GraphView& view,
                          const std::string& plan_graph);

}  // namespace kg_engine

#endif  // KG_ENGINE_EXPORT_PLAN_TRACKS_H_
