// The stops that agents have made: frozen, copied from run to run with the
// provenance they were planned with.

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
  // As stated when it was planned.
  TrackLiteral path{};
  std::vector<std::string> derived_from{};  // IRIs.
  std::vector<std::string> generated_by{};
};

// The executed stops that the graph of `run` holds, by agent and window.
std::vector<ExecutedVisit> ReadExecuted(const kg_core::GraphView& view,
                                        unsigned long long run,
                                        const kg_mission::Mission& mission);

// Where the plan of a run sends the agents: by ex:id and window, of the stops
// that its graph says are still to be made.
using PlannedPlaces = std::map<std::pair<std::string, int>, kg_base::LonLat>;
PlannedPlaces ReadPlanned(const kg_core::GraphView& view,
                          unsigned long long run,
                          const kg_mission::Mission& mission);

// Fills in path and provenance from the stop's assignment in the graph of
// `run`, if there is one.
void RecallPlan(const kg_core::GraphView& view, unsigned long long run,
                ExecutedVisit* stop);

}  // namespace kg_engine

#endif  // KG_ENGINE_STATE_EXECUTED_STOPS_H_
