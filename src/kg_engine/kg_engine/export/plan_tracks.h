// A plan as the store holds it: every agent's stops and the way between them,
// for those who write it in the formats of others. Needs no node and no topic,
// so a plan can be exported after a restart.

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
  double time_s = 0.0;       // End of its path; NaN: it has none.
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
  std::vector<PlannedStop> stops;  // By window.
  // The whole way, cut only where it passes the antimeridian or where there is
  // no path for a while.
  std::vector<Track> parts;
};

struct PlanTracks {
  std::string run_iri;
  unsigned long long world_version = 0;
  std::string status;  // "ok", "stale", ...
  std::string mission_name;
  std::vector<PlannedAgent> agents;  // By id.
};

// Of the plan graph (its IRI). Throws kg_base::InputError if there is no plan
// in it.
PlanTracks ReadPlanTracks(const kg_core::GraphView& view,
                          const std::string& plan_graph);

}  // namespace kg_engine

#endif  // KG_ENGINE_EXPORT_PLAN_TRACKS_H_
