#include "kg_ros/knowledge/plan_facts.h"

#include <algorithm>
#include <cmath>

#include "kg_core/base/join_strings.h"
#include "kg_core/base/units.h"
#include "kg_core/geo/wkt.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_ros/conversion/message_units.h"
#include "kg_ros/conversion/plan_conversion.h"
#include "kg_ros/knowledge/artifact_facts.h"

namespace kg_ros {
namespace {

using kg_compiler::Compilation;
using kg_core::Ex;
using kg_core::GeoTerm;
using kg_core::Iri;
using kg_core::Prov;
using kg_core::Statement;
using kg_core::Term;
using kg_core::WktLiteral;

// Of a track as stated: how far the agent may be from it at any time.
constexpr double kTrackTolerance_m = 10.0;

std::string AgentIri(const Compilation& compilation, const std::string& id) {
  for (const kg_core::Agent& agent : compilation.mission.agents) {
    if (agent.id == id) return agent.iri;
  }
  return "";
}

// What the plan's parts are made of and where they go.
class PlanWriter {
 public:
  PlanWriter(const PlanRecord& record, const Compilation& compilation)
      : record_(record),
        compilation_(compilation),
        run_number_(record.assignments.plan_run),
        run_(PlanRunNode(run_number_)),
        select_(SelectRunNode(run_number_)),
        write_(PlanGraph(run_number_)),
        prove_(Iri(kg_core::kProvGraph)) {}

  std::vector<Statement> Write() {
    WriteRun();
    ProveRun();
    ProveSelection();
    for (const ExecutedVisit& past : record_.executed) WriteExecuted(past);
    for (const kg_msgs::Assignment& assignment :
         record_.assignments.assignments) {
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
    const kg_msgs::Assignments& plan = record_.assignments;
    const bool is_whole = plan.unassigned.empty();
    write_.About(run_, "PlanRun")
        .Integer("worldVersion", static_cast<long long>(plan.world_version))
        .Text("status", is_whole ? "ok" : "failed")
        .Integer("rounds", plan.rounds)
        .Number("reward", plan.reward)
        .Number("seamCost", plan.seam_cost)
        .Text("teamMode", plan.mode);
    WriteQuality(plan);
    for (const std::string& why : plan.unassigned) write_.Text("reason", why);
    WritePlannedWindows();
  }

  void WritePlannedWindows() {
    for (const kg_core::TimeWindow& window : compilation_.mission.windows) {
      if (window.index < compilation_.first_window) continue;
      write_.Link("forWindow", Iri(window.iri));
    }
  }

  // What is not known is not said.
  void WriteQuality(const kg_msgs::Assignments& plan) {
    if (std::isfinite(plan.bound)) write_.Number("bound", plan.bound);
    const double missed = plan.bound - (plan.reward - plan.seam_cost);
    if (std::isfinite(missed) && plan.bound > 0.0) {
      write_.Number("gap", missed / plan.bound);
    }
    if (!std::isfinite(plan.stability)) return;
    write_.Number("stability", plan.stability)
        .Number("displacementKm", plan.displacement_m / 1000.0);
  }

  // What the planners went by.
  void ProveRun() {
    const kg_msgs::Assignments& plan = record_.assignments;
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

  // What the selector went by: everybody's paths, the team's rules.
  void ProveSelection() {
    const double ended_s = std::max(
        FromRosTime(record_.assignments.header.stamp), record_.started_s);
    double took_s = 0.0;
    for (const kg_msgs::StageTime& stage : record_.assignments.stages) {
      if (stage.stage == "select") took_s = stage.seconds;
    }
    prove_
        .Activity(select_, "SelectRun",
                  std::max(ended_s - took_s, record_.started_s), ended_s)
        .Integer("worldVersion",
                 static_cast<long long>(record_.assignments.world_version))
        .Add(Prov("wasInformedBy"), run_)
        .Used(Iri(compilation_.mission.iri));
    for (const auto& [event, capacity] :
         compilation_.coordination.event_capacity) {
      prove_.Used(Iri(event));
    }
    ProveGraphs();
  }

  // The stops on the way, in their order.
  static std::string StopsWkt(const kg_msgs::Visit& visit) {
    const std::size_t name = std::string("POINT").size();
    std::vector<std::string> points;
    for (const kg_msgs::Stop& stop : visit.via) {
      points.push_back(kg_core::PointWkt(GetPosition(stop)).substr(name));
    }
    return "MULTIPOINT(" + kg_core::JoinStrings(points) + ")";
  }

  // What every assignment says.
  void WriteStop(const std::string& agent_id, const std::string& agent_iri,
                 const kg_msgs::Visit& visit, const char* status) {
    write_
        .About(AssignmentNode(run_number_, agent_id, visit.window),
               "Assignment")
        .Link("forAgent", Iri(agent_iri))
        .Link("forWindow", Window(visit.window))
        .Position(Ex("waypointWKT"), GetPosition(visit))
        .Number("reward", visit.reward)
        .Text("status", status);
    if (!visit.via.empty()) {
      write_.Add(Ex("stopsWKT"), WktLiteral(StopsWkt(visit)));
    }
    WriteCost(visit.cost, &write_);
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

  void WriteAssignments(const kg_msgs::Assignment& assignment) {
    const Track track = FromMessage(assignment.pathlet.track);
    double from_s = track.empty() ? 0.0 : track.front().time_s;
    for (const kg_msgs::Visit& visit : assignment.pathlet.visits) {
      WriteStop(assignment.agent, assignment.agent_iri, visit, "planned");
      write_.GeneratedBy(run_).GeneratedBy(select_);
      WriteSources(assignment, visit.window);
      for (const kg_core::TimeWindow& window : compilation_.mission.windows) {
        if (window.index != visit.window) continue;
        WritePath(ToLiteral(CutAtAntimeridian(SimplifyTrack(
            CutTrack(track, from_s, window.end_s), kTrackTolerance_m))));
        from_s = window.end_s;
      }
    }
  }

  void WriteSources(const kg_msgs::Assignment& assignment, int window) {
    const kg_compiler::MissionTensor* tensor =
        FindTensor(compilation_, assignment.agent_iri, window);
    if (tensor != nullptr) {
      write_.DerivedFrom(TensorNode(*tensor, compilation_.mission));
    }
    const kg_compiler::SeamRules* rules =
        FindRules(compilation_, assignment.agent_iri);
    if (rules != nullptr) write_.DerivedFrom(SeamRulesNode(*rules));
    const auto graph = record_.nav_graphs.find({assignment.agent, window});
    if (graph != record_.nav_graphs.end()) {
      write_.DerivedFrom(NavGraphNode(graph->second.hash));
    }
  }

  // Stands for this cycle only; no policy is touched (A31).
  void WriteCooling(std::size_t number) {
    const kg_msgs::Cooling& cooling = record_.cooling[number];
    const Track track =
        SimplifyTrack(FromMessage(cooling.track), kTrackTolerance_m);
    write_.About(Part("cooling/" + std::to_string(number)), "CoolingConstraint")
        .Link("forAgent", Iri(AgentIri(compilation_, cooling.agent)))
        .Number("attenuation", cooling.factor)
        .Number("minimumSeparationKm", cooling.separation_m / 1000.0)
        .Time(Ex("expires"), FromRosTime(cooling.expires))
        .GeneratedBy(run_)
        .GeneratedBy(select_);
    if (cooling.by_agent.empty()) {  // Events that are full, by whomever.
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
    for (const kg_msgs::Assignment& committed :
         record_.assignments.assignments) {
      if (committed.agent != cooling.by_agent) continue;
      for (const kg_msgs::Visit& visit : committed.pathlet.visits) {
        write_.Link("forWindow", Window(visit.window))
            .DerivedFrom(
                AssignmentNode(run_number_, committed.agent, visit.window));
      }
    }
  }

  void WritePrice(std::size_t number) {
    const kg_msgs::Price& price = record_.prices[number];
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
    const kg_msgs::Rejection& rejection = record_.rejections[number];
    write_.About(Part("rejection/" + std::to_string(number)), "Rejection")
        .Link("forAgent", Iri(AgentIri(compilation_, rejection.agent)))
        .Text("kind", rejection.kind)
        .Text("reason", rejection.reason)
        .Integer("rank", rejection.rank)
        .Integer("round", rejection.round)
        .Number("margin", rejection.margin)
        .Number("score", rejection.score)
        .GeneratedBy(run_)
        .GeneratedBy(select_);
    if (!rejection.event.empty()) write_.Link("visits", Iri(rejection.event));
    if (rejection.window >= 0) {
      write_.Link("forWindow", Window(rejection.window));
    }
    const std::string winner = AgentIri(compilation_, rejection.to_agent);
    if (!winner.empty()) write_.Link("lostTo", Iri(winner));
    for (const auto& [key, stamp] : record_.nav_graphs) {
      if (key.first != rejection.agent) continue;
      write_.DerivedFrom(NavGraphNode(stamp.hash));
    }
    LinkCooling(rejection);
  }

  void LinkCooling(const kg_msgs::Rejection& rejection) {
    for (std::size_t i = 0; i < record_.cooling.size(); ++i) {
      const kg_msgs::Cooling& cooling = record_.cooling[i];
      if (cooling.agent != rejection.agent ||
          cooling.by_agent != rejection.to_agent) {
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

Term PlanGraph(unsigned long long run) {
  return Iri(kg_core::kPlanGraphPrefix + std::to_string(run));
}

Term PlanRunNode(unsigned long long run) {
  return Ex("plan/" + std::to_string(run));
}

Term SelectRunNode(unsigned long long run) {
  return Iri(PlanRunNode(run).text + "/select");
}

Term AssignmentNode(unsigned long long run, const std::string& agent_id,
                    int window) {
  return Iri(PlanRunNode(run).text + "/" + agent_id + "/w" +
             std::to_string(window));
}

std::vector<Statement> PlanStatements(const PlanRecord& record,
                                      const Compilation& compilation) {
  return PlanWriter(record, compilation).Write();
}

void WriteCost(const kg_msgs::EdgeCost& cost, FactWriter* write) {
  write->Number("costHours", cost.travel_s / kg_core::kSecondsPerHour)
      .Number("costEnergy", cost.energy_j / kg_core::kJoulesPerWh)
      .Number("costRisk",
              (cost.hazard_s + cost.isolation_s) / kg_core::kSecondsPerHour)
      .Number("seamCost", cost.seam_cost);
}

void StagePlanStatus(const std::uint64_t run, const char* status,
                     kg_core::Transaction* transaction) {
  const Term node = PlanRunNode(run);
  const Term property = kg_core::Ex("status");
  const Term graph = PlanGraph(run);
  const kg_core::GraphView& view = transaction->view();
  if (!kg_core::FirstObject(view, graph.text, node, property)) return;
  transaction->RemoveMatching(&node, &property, nullptr, graph);
  transaction->Add({node, property, kg_core::Literal(status), graph});
}

}  // namespace kg_ros
