// Executed stops: immutable, copied from run to run with their original
// provenance.

#ifndef KG_ENGINE_STATE_EXECUTED_STOPS_H_
#define KG_ENGINE_STATE_EXECUTED_STOPS_H_

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "kg_base/geo/lon_lat.h"
#include "kg_core/rdf/graph_view.h"
#include "kg_engine/terms/track_literal.h"
#include "kg_mission/mission/mission.h"
#include "kg_selector/paths/pathlet.h"

namespace kg_engine {

struct ExecutedVisit {
  std::string agent;  // ex:id.
  std::string agent_iri;
  kg_selector::Visit visit;
  // Path as planned.
  TrackLiteral path{};
  std::vector<std::string> derived_from{};  // IRIs.
  std::vector<std::string> generated_by{};
};

// Executed stops in the graph of `run`, by agent and window.
std::vector<ExecutedVisit> ReadExecuted(const kg_core::GraphView& view,
                                        unsigned long long run,
                                        const kg_mission::Mission& mission);

// Planned end places by ex:id and window, for the stops of a run's graph that
// are not yet executed.
using PlannedPlaces = std::map<std::pair<std::string, int>, kg_base::LonLat>;
PlannedPlaces ReadPlanned(const kg_core::GraphView& view,
                          unsigned long long run,
                          const kg_mission::Mission& mission);

// Fills in path and provenance from the stop's assignment in the graph of
// `run`, if it exists.
void RecallPlan(const kg_core::GraphView& view, unsigned long long run,
                ExecutedVisit* stop);

}  // namespace kg_engine

#endif  // KG_ENGINE_STATE_EXECUTED_STOPS_H_
