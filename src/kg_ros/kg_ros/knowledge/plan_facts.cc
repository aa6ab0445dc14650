#include "kg_ros/knowledge/plan_facts.h"

#include <algorithm>
#include <tuple>

#include "kg_core/base/date_time.h"
#include "kg_core/base/units.h"
#include "kg_core/geo/wkt.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_ros/conversion/message_units.h"

namespace kg_ros {
namespace {

using kg_core::Iri;
using kg_core::Literal;
using kg_core::Statement;
using kg_core::Term;

std::string Ex(const std::string& name) { return kg_core::kEx + name; }
std::string Prov(const std::string& name) { return kg_core::kProv + name; }

// Collects statements about one subject after the other in one graph.
class Writer {
 public:
  explicit Writer(Term graph) : graph_(std::move(graph)) {}

  Writer& About(const Term& subject, const std::string& type) {
    subject_ = subject;
    return Add(std::string(kg_core::kRdf) + "type", Iri(Ex(type)));
  }
  Writer& Add(const std::string& predicate, const Term& object) {
    statements_.push_back({subject_, Iri(predicate), object, graph_});
    return *this;
  }
  Writer& Number(const std::string& name, double value) {
    return Add(Ex(name), kg_core::DoubleLiteral(value));
  }
  Writer& Integer(const std::string& name, long long value) {
    return Add(Ex(name), kg_core::IntegerLiteral(value));
  }
  Writer& Text(const std::string& name, const std::string& value) {
    return Add(Ex(name), Literal(value));
  }
  Writer& Link(const std::string& name, const Term& object) {
    return Add(Ex(name), object);
  }
  Writer& Time(const std::string& predicate, double time_s) {
    return Add(predicate, Literal(kg_core::FormatDateTime(time_s),
                                  std::string(kg_core::kXsd) + "dateTime"));
  }
  std::vector<Statement> Take() { return std::move(statements_); }

 private:
  Term graph_;
  Term subject_;
  std::vector<Statement> statements_;
};

Term WktLiteral(const kg_core::LonLat& position) {
  return Literal(kg_core::PointWkt(position),
                 std::string(kg_core::kGeo) + "wktLiteral");
}

Term WindowTerm(const kg_compiler::Compilation& compilation, int window) {
  for (const kg_core::TimeWindow& known : compilation.mission.windows) {
    if (known.index == window) return Iri(known.iri);
  }
  return Iri(Ex("window/" + std::to_string(window)));
}

Term TensorNode(const std::string& hash) { return Iri(Ex("tensor/" + hash)); }
Term NavGraphNode(const std::string& hash) { return Iri(Ex("nav/" + hash)); }

const kg_compiler::MissionTensor* FindTensor(
    const kg_compiler::Compilation& compilation, const std::string& agent_iri,
    int window) {
  for (const auto& tensor : compilation.tensors) {
    if (tensor->agent_iri == agent_iri && tensor->window == window) {
      return tensor.get();
    }
  }
  return nullptr;
}

void WriteCost(const kg_msgs::EdgeCost& cost, Writer* write) {
  write->Number("costHours", cost.travel_s / kg_core::kSecondsPerHour)
      .Number("costEnergy", cost.energy_j / kg_core::kJoulesPerWh)
      .Number("costRisk", cost.hazard_s / kg_core::kSecondsPerHour)
      .Number("seamCost", cost.seam_cost);
}

Term WaypointNode(const Term& graph, unsigned id) {
  return Iri(graph.text + "/waypoint/" + std::to_string(id));
}

double NumberOf(const kg_core::GraphView& view, const std::string& graph,
                const Term& node, const std::string& name) {
  const auto value = kg_core::FirstObject(view, graph, node, Iri(Ex(name)));
  return value ? kg_core::NumericValue(*value).value_or(0.0) : 0.0;
}

std::string TextOf(const kg_core::GraphView& view, const std::string& graph,
                   const Term& node, const std::string& name) {
  const auto value = kg_core::FirstObject(view, graph, node, Iri(Ex(name)));
  return value ? value->text : "";
}

// The inverse of WriteAssignment.
ExecutedVisit ReadStop(const kg_core::GraphView& view, const std::string& graph,
                       const Term& node, const kg_core::Mission& mission) {
  ExecutedVisit stop;
  stop.agent_iri = TextOf(view, graph, node, "forAgent");
  const kg_core::Agent* agent = mission.FindAgent(stop.agent_iri);
  if (agent != nullptr) stop.agent = agent->id;
  const std::string window_iri = TextOf(view, graph, node, "forWindow");
  for (const kg_core::TimeWindow& window : mission.windows) {
    if (window.iri == window_iri) stop.visit.window = window.index;
  }
  const std::string wkt = TextOf(view, graph, node, "waypointWKT");
  if (!wkt.empty()) {
    SetPosition(kg_core::Geometry::FromWkt(wkt).Point(), &stop.visit);
  }
  stop.visit.reward = NumberOf(view, graph, node, "reward");
  kg_msgs::EdgeCost& cost = stop.visit.cost;
  cost.travel_s =
      kg_core::HoursToSeconds(NumberOf(view, graph, node, "costHours"));
  cost.energy_j =
      kg_core::WhToJoules(NumberOf(view, graph, node, "costEnergy"));
  cost.hazard_s =
      kg_core::HoursToSeconds(NumberOf(view, graph, node, "costRisk"));
  cost.seam_cost = NumberOf(view, graph, node, "seamCost");
  for (const Term& event :
       kg_core::Objects(view, graph, node, Iri(Ex("visits")))) {
    stop.visit.events.push_back(event.text);
  }
  return stop;
}

struct Stop {
  std::string agent;
  std::string agent_iri;
  const kg_msgs::Visit* visit;
  const char* status;
};

void WriteAssignment(const PlanRecord& record, const Stop& stop,
                     const kg_compiler::Compilation& compilation,
                     Writer* write) {
  const kg_msgs::Visit& visit = *stop.visit;
  const unsigned long long run = record.assignments.plan_run;
  write
      ->About(Iri(PlanRunNode(run).text + "/" + stop.agent + "/w" +
                  std::to_string(visit.window)),
              "Assignment")
      .Link("forAgent", Iri(stop.agent_iri))
      .Link("forWindow", WindowTerm(compilation, visit.window))
      .Link("waypointWKT", WktLiteral(GetPosition(visit)))
      .Number("reward", visit.reward)
      .Text("status", stop.status)
      .Add(Prov("wasGeneratedBy"), PlanRunNode(run));
  WriteCost(visit.cost, write);
  for (const std::string& event : visit.events) {
    write->Link("visits", Iri(event));
  }
  const kg_compiler::MissionTensor* tensor =
      FindTensor(compilation, stop.agent_iri, visit.window);
  if (tensor != nullptr) {
    write->Add(Prov("wasDerivedFrom"), TensorNode(tensor->hash));
  }
  const auto graph = record.nav_graph_hashes.find({stop.agent, visit.window});
  if (graph != record.nav_graph_hashes.end() && tensor != nullptr) {
    write->Add(Prov("wasDerivedFrom"), NavGraphNode(graph->second));
  }
}

void WriteRun(const PlanRecord& record,
              const kg_compiler::Compilation& compilation, Writer* write) {
  const kg_msgs::Assignments& plan = record.assignments;
  write->About(PlanRunNode(plan.plan_run), "PlanRun")
      .Integer("worldVersion", static_cast<long long>(plan.world_version))
      .Text("status", "ok")
      .Integer("rounds", plan.rounds)
      .Number("reward", plan.reward)
      .Number("seamCost", plan.seam_cost)
      .Time(Prov("startedAtTime"), record.started_s)
      .Time(Prov("endedAtTime"), record.ended_s);
  for (const auto& tensor : compilation.tensors) {
    write->Add(Prov("used"), TensorNode(tensor->hash));
  }
  for (const kg_core::TimeWindow& window : compilation.mission.windows) {
    if (window.index >= compilation.first_window) {
      write->Link("forWindow", Iri(window.iri));
    }
  }
}

void WriteRejection(const PlanRecord& record, std::size_t number,
                    const kg_compiler::Compilation& compilation,
                    Writer* write) {
  const kg_msgs::Rejection& rejection = record.rejections[number];
  const Term run = PlanRunNode(record.assignments.plan_run);
  write
      ->About(Iri(run.text + "/rejection/" + std::to_string(number)),
              "Rejection")
      .Link("forAgent", Iri(rejection.agent_iri))
      .Text("kind", rejection.kind)
      .Text("reason", rejection.reason)
      .Integer("rank", rejection.rank)
      .Integer("round", rejection.round)
      .Number("margin", rejection.margin)
      .Number("score", rejection.score)
      .Add(Prov("wasGeneratedBy"), run);
  if (!rejection.event.empty()) write->Link("visits", Iri(rejection.event));
  if (rejection.window >= 0) {
    write->Link("forWindow", WindowTerm(compilation, rejection.window));
  }
  for (const kg_core::Agent& agent : compilation.mission.agents) {
    if (agent.id == rejection.to_agent) {
      write->Link("lostTo", Iri(agent.iri));
    }
  }
}

void WriteTensor(const kg_compiler::MissionTensor& tensor,
                 const kg_compiler::Compilation& compilation, Writer* write) {
  write->About(TensorNode(tensor.hash), "HeatmapArtifact")
      .Link("forAgent", Iri(tensor.agent_iri))
      .Link("forWindow", WindowTerm(compilation, tensor.window))
      .Text("tensorKind", "FUSED")
      .Text("hash", tensor.hash);
  for (const std::string& source : tensor.derived_from) {
    write->Add(Prov("wasDerivedFrom"), Iri(source));
  }
}

void WriteEdgeCost(const Term& edge, const std::string& agent_iri,
                   const kg_msgs::EdgeCost& cost, Writer* write) {
  write->About(Iri(edge.text + "/cost"), "EdgeCost")
      .Link("forEdge", edge)
      .Link("forAgent", Iri(agent_iri));
  WriteCost(cost, write);
}

}  // namespace

Term EdgeNode(const std::string& graph_hash, unsigned from, unsigned to) {
  return Iri(NavGraphNode(graph_hash).text + "/edge/" + std::to_string(from) +
             "-" + std::to_string(to));
}

std::vector<Statement> EdgeCostStatements(const Term& graph, const Term& edge,
                                          const std::string& agent_iri,
                                          const kg_msgs::EdgeCost& cost) {
  Writer write(graph);
  WriteEdgeCost(edge, agent_iri, cost, &write);
  return write.Take();
}

Term PlanGraph(unsigned long long run) {
  return Iri(kg_core::kPlanGraphPrefix + std::to_string(run));
}

Term PlanRunNode(unsigned long long run) {
  return Iri(Ex("plan/" + std::to_string(run)));
}

std::vector<Statement> PlanStatements(
    const PlanRecord& record, const kg_compiler::Compilation& compilation) {
  Writer write(PlanGraph(record.assignments.plan_run));
  WriteRun(record, compilation, &write);
  for (const ExecutedVisit& past : record.executed) {
    WriteAssignment(record,
                    {past.agent, past.agent_iri, &past.visit, "executed"},
                    compilation, &write);
  }
  for (const kg_msgs::Assignment& assignment : record.assignments.assignments) {
    for (const kg_msgs::Visit& visit : assignment.pathlet.visits) {
      WriteAssignment(
          record, {assignment.agent, assignment.agent_iri, &visit, "planned"},
          compilation, &write);
    }
  }
  for (std::size_t i = 0; i < record.rejections.size(); ++i) {
    WriteRejection(record, i, compilation, &write);
  }
  for (const auto& tensor : compilation.tensors) {
    WriteTensor(*tensor, compilation, &write);
  }
  return write.Take();
}

std::vector<Statement> NavGraphStatements(const kg_msgs::NavGraph& graph,
                                          const NavGraphPlace& place) {
  Writer write(PlanGraph(place.run));
  const Term node = NavGraphNode(graph.hash);
  write.About(node, "NavGraph")
      .Link("forAgent", Iri(graph.agent_iri))
      .Link("forWindow", Iri(place.window_iri))
      .Text("movementMode", graph.movement_mode)
      .Text("hash", graph.hash);
  for (const kg_msgs::Waypoint& waypoint : graph.waypoints) {
    write.About(WaypointNode(node, waypoint.id), "Waypoint")
        .Link("inGraph", node)
        .Number("score", waypoint.score)
        .Add(std::string(kg_core::kGeo) + "asWKT",
             WktLiteral(GetPosition(waypoint)));
  }
  for (const kg_msgs::TraverseEdge& edge : graph.edges) {
    const Term edge_node = EdgeNode(graph.hash, edge.from, edge.to);
    const Term from =
        place.previous_hash.empty()
            ? Iri(place.start_iri)
            : WaypointNode(NavGraphNode(place.previous_hash), edge.from);
    write.About(edge_node, "TraverseEdge")
        .Link("inGraph", node)
        .Link("from", from)
        .Link("to", WaypointNode(node, edge.to));
    WriteEdgeCost(edge_node, graph.agent_iri, edge.cost, &write);
  }
  return write.Take();
}

std::vector<ExecutedVisit> ReadExecuted(const kg_core::GraphView& view,
                                        unsigned long long run,
                                        const kg_core::Mission& mission) {
  const std::string graph = PlanGraph(run).text;
  std::vector<ExecutedVisit> executed;
  for (const Term& node :
       kg_core::Subjects(view, graph, Iri(Ex("status")), Literal("executed"))) {
    executed.push_back(ReadStop(view, graph, node, mission));
  }
  std::sort(executed.begin(), executed.end(),
            [](const ExecutedVisit& a, const ExecutedVisit& b) {
              return std::tie(a.agent, a.visit.window) <
                     std::tie(b.agent, b.visit.window);
            });
  return executed;
}

}  // namespace kg_ros
