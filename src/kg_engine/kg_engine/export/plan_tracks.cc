#include "kg_engine/export/plan_tracks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "kg_base/common/input_error.h"
#include "kg_base/geo/wkt.h"
#include "kg_core/facts/terms.h"
#include "kg_core/rdf/namespaces.h"

namespace kg_engine {
namespace {

using kg_core::Ex;
using kg_core::GraphView;
using kg_core::Term;

class PlanReader {
 public:
  PlanReader(const GraphView& view, const std::string& graph)
      : view_(view), graph_(graph) {}

  PlanTracks Read() {
    const std::vector<Term> runs =
        kg_core::Subjects(view_, graph_, kg_core::RdfType(), Ex("PlanRun"));
    if (runs.size() != 1) {
      throw kg_base::InputError("<" + graph_ + "> holds no plan");
    }
    PlanTracks plan;
    plan.run_iri = runs[0].text;
    plan.world_version =
        static_cast<unsigned long long>(Number(runs[0], "worldVersion"));
    plan.status = Text(runs[0], "status");
    plan.mission_name = MissionName();
    for (const Term& node : kg_core::Subjects(view_, graph_, kg_core::RdfType(),
                                              Ex("Assignment"))) {
      ReadStop(node);
    }
    for (auto& [iri, agent] : agents_) {
      Finish(&agent);
      plan.agents.push_back(std::move(agent));
    }
    std::sort(plan.agents.begin(), plan.agents.end(),
              [](const PlannedAgent& a, const PlannedAgent& b) {
                return a.id < b.id;
              });
    return plan;
  }

 private:
  std::string Text(const Term& node, const char* name) const {
    const auto value = kg_core::FirstObject(view_, graph_, node, Ex(name));
    return value ? value->text : "";
  }
  double Number(const Term& node, const char* name) const {
    const auto value = kg_core::FirstObject(view_, graph_, node, Ex(name));
    return value ? kg_core::NumericValue(*value).value_or(0.0) : 0.0;
  }
  std::string FactText(const Term& node, const char* name,
                       const std::string& fallback) const {
    const auto value =
        kg_core::FirstObject(view_, kg_core::kFactsGraph, node, Ex(name));
    return value ? value->text : fallback;
  }

  std::string MissionName() const {
    const std::vector<Term> missions = kg_core::Subjects(
        view_, kg_core::kFactsGraph, kg_core::RdfType(), Ex("Mission"));
    return missions.empty() ? "" : FactText(missions[0], "name", "");
  }

  void ReadStop(const Term& node) {
    const Term agent_node = kg_core::Iri(Text(node, "forAgent"));
    PlannedAgent& agent = agents_[agent_node.text];
    agent.iri = agent_node.text;
    agent.id = FactText(agent_node, "id",
                        agent.iri.substr(agent.iri.find_last_of("/#") + 1));
    PlannedStop stop;
    stop.window_iri = Text(node, "forWindow");
    stop.window = std::atoi(
        FactText(kg_core::Iri(stop.window_iri), "index", "-1").c_str());
    stop.status = Text(node, "status");
    stop.position =
        kg_base::Geometry::FromWkt(Text(node, "waypointWKT")).Point();
    stop.reward = Number(node, "reward");
    stop.seam_cost = Number(node, "seamCost");
    stop.travel_h = Number(node, "costHours");
    stop.energy_wh = Number(node, "costEnergy");
    stop.risk_h = Number(node, "costRisk");
    for (const Term& event :
         kg_core::Objects(view_, graph_, node, Ex("visits"))) {
      stop.events.push_back(event.text);
    }
    // The path is optional; its last point gives the end time.
    stop.time_s = std::numeric_limits<double>::quiet_NaN();
    const TrackLiteral path = {Text(node, "pathWKT"), Text(node, "pathTimes")};
    if (!path.wkt.empty()) {
      std::vector<Track> parts = FromLiteral(path);
      stop.time_s = parts.back().back().time_s;
      for (Track& part : parts) agent.parts.push_back(std::move(part));
    }
    agent.stops.push_back(std::move(stop));
  }

  // Sorts stops and joins adjacent parts.
  static void Finish(PlannedAgent* agent) {
    std::sort(agent->stops.begin(), agent->stops.end(),
              [](const PlannedStop& a, const PlannedStop& b) {
                return a.window < b.window;
              });
    std::stable_sort(agent->parts.begin(), agent->parts.end(),
                     [](const Track& a, const Track& b) {
                       return a.front().time_s < b.front().time_s;
                     });
    std::vector<Track> joined;
    for (const Track& part : agent->parts) {
      if (joined.empty() || !Meet(joined.back().back(), part.front())) {
        joined.push_back(part);
      } else {
        Track& last = joined.back();
        last.insert(last.end(), part.begin() + 1, part.end());
      }
    }
    agent->parts = std::move(joined);
  }

  static bool Meet(const kg_compiler::TimedPoint& a,
                   const kg_compiler::TimedPoint& b) {
    return a.time_s == b.time_s && a.position == b.position;
  }

  const GraphView& view_;
  const std::string graph_;
  std::map<std::string, PlannedAgent> agents_;
};

}  // namespace

PlanTracks ReadPlanTracks(const GraphView& view,
                          const std::string& plan_graph) {
  return PlanReader(view, plan_graph).Read();
}

}  // namespace kg_engine
