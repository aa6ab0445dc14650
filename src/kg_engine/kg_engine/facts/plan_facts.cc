#include "kg_engine/facts/plan_facts.h"

#include <algorithm>
#include <cmath>

#include "kg_base/common/join_strings.h"
#include "kg_base/common/units.h"
#include "kg_base/geo/wkt.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_engine/facts/fact_writer.h"
#include "kg_engine/terms/artifact_names.h"
#include "kg_engine/terms/plan_names.h"
#include "kg_engine/terms/track_literal.h"

namespace kg_engine {
namespace {

using kg_compiler::Compilation;
using kg_core::Ex;
using kg_core::GeoTerm;
using kg_core::Iri;
using kg_core::Prov;
using kg_core::Statement;
using kg_core::Term;
using kg_core::WktLiteral;

// Maximum distance between the agent and the simplified track at any time [m].
constexpr double kTrackTolerance_m = 10.0;

std::string AgentIri(const Compilation& compilation, const std::string& id) {
  for (const kg_mission::Agent& agent : compilation.mission.agents) {
    if (agent.id == id) return agent.iri;
  }
  return "";
}

// Writes the plan's parts and their provenance.
class PlanWriter {
 public:
  PlanWriter(const PlanRecord& record, const Compilation& compilation)
      : record_(record),
        compilation_(compilation),
        run_number_(record.plan.run),
        run_(PlanRunNode(run_number_)),
        select_(SelectRunNode(run_number_)),
        write_(PlanGraph(run_number_)),
        prove_(Iri(kg_core::kProvGraph)) {}

  std::vector<Statement> Write() {
    WriteRun();
    ProveRun();
    ProveSelection();
    for (const ExecutedVisit& past : record_.executed) WriteExecuted(past);
    for (const kg_selector::PathAssignment& assignment :
         record_.plan.assignments) {
      WriteAssignments(assignment);
    }
    for (std::size_t i = 0; i < record_.cooling.size(); ++i) WriteCooling(i);
    for (std::size_t i = 0; i < record_.prices.size(); ++i) WritePrice(i);
    for (std::size_t i = 0; i < record_.rejections.size(); ++i) {
      WriteRejection(i);
    }
    std::vector<Statement> all = write_.Take();
    for (Statement& statement : prove_.Take()) {
      all.push_back(std::move(statement));
    }
    return all;
  }

 private:
  using Key = std::pair<std::string, int>;

  Term Part(const std::string& name) const {
    return Iri(run_.text + "/" + name);
  }
  Term Window(int window) const {
    return WindowTerm(compilation_.mission, window);
  }

  void WriteRun() {
    const kg_selector::CommittedPlan& plan = record_.plan;
    const bool is_whole = plan.unassigned.empty();
    write_.About(run_, "PlanRun")
        .Integer("worldVersion", static_cast<long long>(plan.world_version))
        .Text("status", is_whole ? "ok" : "failed")
        .Integer("rounds", plan.rounds)
        .Number("reward", plan.reward)
        .Number("seamCost", plan.seam_cost)
        .Text("teamMode", plan.mode);
    WriteQuality(plan);
    for (const std::string& why : kg_selector::UnassignedLines(plan)) {
      write_.Text("reason", why);
    }
    WritePlannedWindows();
  }

  void WritePlannedWindows() {
    for (const kg_mission::TimeWindow& window : compilation_.mission.windows) {
      if (window.index < compilation_.first_window) continue;
      write_.Link("forWindow", Iri(window.iri));
    }
  }

  // Unknown values are omitted.
  void WriteQuality(const kg_selector::CommittedPlan& plan) {
    if (std::isfinite(plan.bound)) write_.Number("bound", plan.bound);
    const double missed = plan.bound - (plan.reward - plan.seam_cost);
    if (std::isfinite(missed) && plan.bound > 0.0) {
      write_.Number("gap", missed / plan.bound);
    }
    if (!std::isfinite(plan.stability)) return;
    write_.Number("stability", plan.stability)
        .Number("displacementKm", plan.displacement_m / 1000.0);
  }

  // Provenance of the planners' results.
  void ProveRun() {
    const kg_selector::CommittedPlan& plan = record_.plan;
    prove_.Activity(run_, "PlanRun", record_.started_s, record_.ended_s)
        .Integer("worldVersion", static_cast<long long>(plan.world_version));
    for (const auto& tensor : compilation_.tensors) {
      prove_.Used(TensorNode(*tensor, compilation_.mission));
    }
    for (const kg_compiler::SeamRules& rules : compilation_.rules) {
      prove_.Used(SeamRulesNode(rules));
    }
    for (const auto& field : compilation_.fields) {
      prove_.Used(Iri(field->iri));
    }
    ProveGraphs();
  }

  void ProveGraphs() {
    for (const auto& [key, stamp] : record_.nav_graphs) {
      prove_.Used(NavGraphNode(stamp.hash));
    }
  }

  // Provenance of the selection: all agents' paths, the team's rules.
  void ProveSelection() {
    const double ended_s = std::max(record_.plan.time_s, record_.started_s);
    double took_s = 0.0;
    for (const kg_selector::StageTime& stage : record_.plan.stages) {
      if (stage.stage == "select") took_s = stage.seconds;
    }
    prove_
        .Activity(select_, "SelectRun",
                  std::max(ended_s - took_s, record_.started_s), ended_s)
        .Integer("worldVersion",
                 static_cast<long long>(record_.plan.world_version))
        .Add(Prov("wasInformedBy"), run_)
        .Used(Iri(compilation_.mission.iri));
    for (const auto& [event, capacity] :
         compilation_.coordination.event_capacity) {
      prove_.Used(Iri(event));
    }
    ProveGraphs();
  }

  // Stops on the way, in visiting order.
  static std::string StopsWkt(const kg_selector::Visit& visit) {
    const std::size_t name = std::string("POINT").size();
    const auto to_point = [&](const kg_selector::Stop& stop) {
      return kg_base::PointWkt(stop.position).substr(name);
    };
    return "MULTIPOINT(" + kg_base::JoinStrings(visit.via, ", ", to_point) +
           ")";
  }

  // Statements common to every assignment.
  void WriteStop(const std::string& agent_id, const std::string& agent_iri,
                 const kg_selector::Visit& visit, const char* status) {
    write_
        .About(AssignmentNode(run_number_, agent_id, visit.window),
               "Assignment")
        .Link("forAgent", Iri(agent_iri))
        .Link("forWindow", Window(visit.window))
        .Position(Ex("waypointWKT"), visit.position)
        .Number("reward", visit.reward)
        .Text("status", status);
    if (!visit.via.empty()) {
      write_.Add(Ex("stopsWKT"), WktLiteral(StopsWkt(visit)));
    }
    write_.Cost(visit.cost);
    for (const std::string& event : visit.events) {
      write_.Link("visits", Iri(event));
    }
  }

  void WritePath(const TrackLiteral& path) {
    if (path.wkt.empty()) return;
    write_.Add(Ex("pathWKT"), WktLiteral(path.wkt))
        .Text("pathTimes", path.times);
  }

  void WriteExecuted(const ExecutedVisit& past) {
    WriteStop(past.agent, past.agent_iri, past.visit, "executed");
    WritePath(past.path);
    write_.DerivedFrom(past.derived_from);
    for (const std::string& activity : past.generated_by) {
      write_.GeneratedBy(Iri(activity));
    }
    if (past.generated_by.empty()) write_.GeneratedBy(run_);
  }

  void WriteAssignments(const kg_selector::PathAssignment& assignment) {
    const Track& track = assignment.pathlet.track;
    double from_s = track.empty() ? 0.0 : track.front().time_s;
    for (const kg_selector::Visit& visit : assignment.pathlet.visits) {
      WriteStop(assignment.pathlet.agent, assignment.agent_iri, visit,
                "planned");
      write_.GeneratedBy(run_).GeneratedBy(select_);
      WriteSources(assignment, visit.window);
      for (const kg_mission::TimeWindow& window :
           compilation_.mission.windows) {
        if (window.index != visit.window) continue;
        WritePath(ToLiteral(CutAtAntimeridian(SimplifyTrack(
            CutTrack(track, from_s, window.end_s), kTrackTolerance_m))));
        from_s = window.end_s;
      }
    }
  }

  void WriteSources(const kg_selector::PathAssignment& assignment, int window) {
    const kg_compiler::MissionTensor* tensor =
        FindTensor(compilation_, assignment.agent_iri, window);
    if (tensor != nullptr) {
      write_.DerivedFrom(TensorNode(*tensor, compilation_.mission));
    }
    const kg_compiler::SeamRules* rules =
        FindRules(compilation_, assignment.agent_iri);
    if (rules != nullptr) write_.DerivedFrom(SeamRulesNode(*rules));
    const auto graph =
        record_.nav_graphs.find({assignment.pathlet.agent, window});
    if (graph != record_.nav_graphs.end()) {
      write_.DerivedFrom(NavGraphNode(graph->second.hash));
    }
  }

  // Valid for this cycle only; policies are not changed (A31).
  void WriteCooling(std::size_t number) {
    const kg_selector::CoolingConstraint& cooling = record_.cooling[number];
    const Track track = SimplifyTrack(cooling.track, kTrackTolerance_m);
    write_.About(Part("cooling/" + std::to_string(number)), "CoolingConstraint")
        .Link("forAgent", Iri(AgentIri(compilation_, cooling.agent)))
        .Number("attenuation", cooling.factor)
        .Number("minimumSeparationKm", cooling.separation_m / 1000.0)
        .Time(Ex("expires"), cooling.expires_s)
        .GeneratedBy(run_)
        .GeneratedBy(select_);
    if (cooling.by_agent.empty()) {  // Full events, regardless of the visitors.
      WritePlannedWindows();
    } else {
      write_.Link("cooledBy", Iri(AgentIri(compilation_, cooling.by_agent)));
    }
    if (!track.empty()) {
      write_.Add(GeoTerm("asWKT"),
                 WktLiteral(ToLiteral(CutAtAntimeridian(track)).wkt));
    }
    for (const std::string& event : cooling.full_events) {
      write_.Link("visits", Iri(event));
    }
    for (const kg_selector::PathAssignment& committed :
         record_.plan.assignments) {
      if (committed.pathlet.agent != cooling.by_agent) continue;
      for (const kg_selector::Visit& visit : committed.pathlet.visits) {
        write_.Link("forWindow", Window(visit.window))
            .DerivedFrom(AssignmentNode(run_number_, committed.pathlet.agent,
                                        visit.window));
      }
    }
  }

  void WritePrice(std::size_t number) {
    const kg_selector::VisitPrice& price = record_.prices[number];
    if (!(price.price > 0.0)) return;
    write_.About(Part("price/" + std::to_string(number)), "Price")
        .Number("price", price.price)
        .GeneratedBy(run_)
        .GeneratedBy(select_);
    const std::string agent = AgentIri(compilation_, price.agent);
    if (!agent.empty()) write_.Link("forAgent", Iri(agent));
    if (!price.event.empty()) {
      write_.Link("visits", Iri(price.event));
      return;
    }
    write_.Link("forWindow", Window(price.window));
    const auto graph = record_.nav_graphs.find({price.agent, price.window});
    if (graph == record_.nav_graphs.end()) return;
    write_.Link("ofWaypoint", WaypointNode(graph->second.hash, price.waypoint))
        .DerivedFrom(NavGraphNode(graph->second.hash));
  }

  void WriteRejection(std::size_t number) {
    const kg_selector::RejectedPath& rejection =
        record_.rejections[number].rejection;
    const kg_selector::Conflict& conflict = rejection.conflict;
    const kg_selector::Pathlet& pathlet = rejection.pathlet;
    write_.About(Part("rejection/" + std::to_string(number)), "Rejection")
        .Link("forAgent", Iri(AgentIri(compilation_, pathlet.agent)))
        .Text("kind", kg_selector::Name(conflict.kind))
        .Text("reason", rejection.reason)
        .Integer("rank", pathlet.rank)
        .Integer("round", rejection.round)
        .Number("margin", conflict.margin)
        .Number("score", pathlet.score())
        .GeneratedBy(run_)
        .GeneratedBy(select_);
    if (!conflict.event.empty()) write_.Link("visits", Iri(conflict.event));
    if (conflict.window >= 0) {
      write_.Link("forWindow", Window(conflict.window));
    }
    const std::string winner = AgentIri(compilation_, conflict.with_agent);
    if (!winner.empty()) write_.Link("lostTo", Iri(winner));
    for (const auto& [key, stamp] : record_.nav_graphs) {
      if (key.first != pathlet.agent) continue;
      write_.DerivedFrom(NavGraphNode(stamp.hash));
    }
    LinkCooling(rejection);
  }

  void LinkCooling(const kg_selector::RejectedPath& rejection) {
    for (std::size_t i = 0; i < record_.cooling.size(); ++i) {
      const kg_selector::CoolingConstraint& cooling = record_.cooling[i];
      if (cooling.agent != rejection.pathlet.agent ||
          cooling.by_agent != rejection.conflict.with_agent) {
        continue;
      }
      write_.Link("cooling", Part("cooling/" + std::to_string(i)));
    }
  }

  const PlanRecord& record_;
  const Compilation& compilation_;
  const unsigned long long run_number_;
  const Term run_;
  const Term select_;
  FactWriter write_;
  FactWriter prove_;
};

}  // namespace

std::vector<Statement> PlanStatements(const PlanRecord& record,
                                      const Compilation& compilation) {
  return PlanWriter(record, compilation).Write();
}

}  // namespace kg_engine
