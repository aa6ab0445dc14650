#include "kg_engine/state/executed_stops.h"

#include <algorithm>
#include <tuple>

#include "kg_base/common/units.h"
#include "kg_base/geo/wkt.h"
#include "kg_core/facts/terms.h"
#include "kg_engine/terms/plan_names.h"

namespace kg_engine {
namespace {

using kg_core::Ex;
using kg_core::GraphView;
using kg_core::Iri;
using kg_core::Literal;
using kg_core::Prov;
using kg_core::Term;

// A node in one graph.
class Node {
 public:
  Node(const GraphView& view, std::string graph, Term node)
      : view_(view), graph_(std::move(graph)), node_(std::move(node)) {}

  double Number(const char* name) const {
    const auto value = kg_core::FirstObject(view_, graph_, node_, Ex(name));
    return value ? kg_core::NumericValue(*value).value_or(0.0) : 0.0;
  }
  std::string Text(const char* name) const {
    const auto value = kg_core::FirstObject(view_, graph_, node_, Ex(name));
    return value ? value->text : "";
  }
  std::vector<std::string> All(const Term& property) const {
    std::vector<std::string> all;
    for (const Term& value : kg_core::Objects(view_, graph_, node_, property)) {
      all.push_back(value.text);
    }
    std::sort(all.begin(), all.end());
    return all;
  }

 private:
  const GraphView& view_;
  std::string graph_;
  Term node_;
};

void ReadPlan(const Node& node, ExecutedVisit* stop) {
  stop->path = {node.Text("pathWKT"), node.Text("pathTimes")};
  stop->derived_from = node.All(Prov("wasDerivedFrom"));
  stop->generated_by = node.All(Prov("wasGeneratedBy"));
}

// Inverse of the stops in PlanStatements().
ExecutedVisit ReadStop(const Node& node, const kg_mission::Mission& mission) {
  ExecutedVisit stop;
  stop.agent_iri = node.Text("forAgent");
  const kg_mission::Agent* agent = mission.FindAgent(stop.agent_iri);
  if (agent != nullptr) stop.agent = agent->id;
  const std::string window_iri = node.Text("forWindow");
  for (const kg_mission::TimeWindow& window : mission.windows) {
    if (window.iri == window_iri) stop.visit.window = window.index;
  }
  const std::string wkt = node.Text("waypointWKT");
  if (!wkt.empty()) {
    stop.visit.position = kg_base::Geometry::FromWkt(wkt).Point();
  }
  // Stops on the way are optional (mode "edges" only).
  const std::string stops = node.Text("stopsWKT");
  if (!stops.empty()) {
    for (const auto& point : kg_base::Geometry::FromWkt(stops).Parts().lines) {
      stop.visit.via.push_back({0, point.front()});
    }
  }
  stop.visit.reward = node.Number("reward");
  kg_compiler::EdgeCost& cost = stop.visit.cost;
  cost.travel_s = kg_base::HoursToSeconds(node.Number("costHours"));
  cost.energy_j = kg_base::WhToJoules(node.Number("costEnergy"));
  cost.hazard_s = kg_base::HoursToSeconds(node.Number("costRisk"));
  cost.turn_rad = node.Number("costTurn");
  cost.seam_cost = node.Number("seamCost");
  stop.visit.events = node.All(Ex("visits"));
  ReadPlan(node, &stop);
  return stop;
}

std::vector<ExecutedVisit> ReadStops(const GraphView& view,
                                     const unsigned long long run,
                                     const kg_mission::Mission& mission,
                                     const char* status) {
  const std::string graph = PlanGraph(run).text;
  std::vector<ExecutedVisit> stops;
  for (const Term& node :
       kg_core::Subjects(view, graph, Ex("status"), Literal(status))) {
    stops.push_back(ReadStop({view, graph, node}, mission));
  }
  return stops;
}

}  // namespace

std::vector<ExecutedVisit> ReadExecuted(const GraphView& view,
                                        const unsigned long long run,
                                        const kg_mission::Mission& mission) {
  std::vector<ExecutedVisit> executed =
      ReadStops(view, run, mission, "executed");
  std::sort(executed.begin(), executed.end(),
            [](const ExecutedVisit& a, const ExecutedVisit& b) {
              return std::tie(a.agent, a.visit.window) <
                     std::tie(b.agent, b.visit.window);
            });
  return executed;
}

PlannedPlaces ReadPlanned(const GraphView& view, const unsigned long long run,
                          const kg_mission::Mission& mission) {
  PlannedPlaces places;
  for (const ExecutedVisit& stop : ReadStops(view, run, mission, "planned")) {
    places[{stop.agent, stop.visit.window}] = stop.visit.position;
  }
  return places;
}

void RecallPlan(const GraphView& view, const unsigned long long run,
                ExecutedVisit* stop) {
  const Term node = AssignmentNode(run, stop->agent, stop->visit.window);
  ReadPlan({view, PlanGraph(run).text, node}, stop);
}

}  // namespace kg_engine
