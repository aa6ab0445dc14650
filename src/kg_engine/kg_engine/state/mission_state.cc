#include "kg_engine/state/mission_state.h"

#include <optional>

#include "kg_base/common/date_time.h"
#include "kg_base/common/units.h"
#include "kg_base/geo/wkt.h"
#include "kg_core/facts/terms.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_engine/terms/plan_names.h"

namespace kg_engine {
namespace {

using kg_core::Ex;
using kg_core::GraphView;
using kg_core::Iri;
using kg_core::Literal;
using kg_core::Term;

Term StateNode() { return Ex("state"); }
Term ResultTime() { return Iri(std::string(kg_core::kSosa) + "resultTime"); }

std::optional<Term> Read(const GraphView& view, const Term& node,
                         const Term& property) {
  return kg_core::FirstObject(view, kg_core::kStateGraph, node, property);
}

double Number(const GraphView& view, const Term& node,
              const std::string& name) {
  const auto value = Read(view, node, Ex(name));
  if (!value) return std::numeric_limits<double>::quiet_NaN();
  return kg_core::NumericValue(*value).value_or(
      std::numeric_limits<double>::quiet_NaN());
}

std::uint64_t Count(const GraphView& view, const std::string& name) {
  const double value = Number(view, StateNode(), name);
  return value >= 0.0 ? static_cast<std::uint64_t>(value) : 0;
}

double Time(const GraphView& view, const Term& node, const Term& property) {
  const auto value = Read(view, node, property);
  return value ? kg_base::ParseDateTime(value->text) : 0.0;
}

AgentPose ReadPose(const GraphView& view, const Term& node) {
  AgentPose pose;
  const auto wkt = Read(view, node, Iri(std::string(kg_core::kGeo) + "asWKT"));
  if (wkt) pose.position = kg_base::Geometry::FromWkt(wkt->text).Point();
  pose.heading_rad = kg_base::DegToRad(Number(view, node, "headingDeg"));
  pose.time_s = Time(view, node, ResultTime());
  pose.energy_left_j =
      kg_base::WhToJoules(Number(view, node, "energyRemaining"));
  pose.observed = !Read(view, node, kg_core::Prov("wasDerivedFrom"));
  return pose;
}

Term DateTime(double time_s) {
  return Literal(kg_base::FormatDateTime(time_s),
                 std::string(kg_core::kXsd) + "dateTime");
}

// Adds statements about one node of the state graph.
class Writer {
 public:
  Writer(Term node, kg_core::Transaction* transaction)
      : node_(std::move(node)), transaction_(transaction) {}
  Writer& Add(const Term& property, const Term& value) {
    transaction_->Add({node_, property, value, Iri(kg_core::kStateGraph)});
    return *this;
  }

 private:
  Term node_;
  kg_core::Transaction* transaction_;
};

// Window that contains the time; clamped to the first and last.
Term WindowAt(const kg_mission::Mission& mission, double time_s) {
  std::string iri = mission.windows.front().iri;
  for (const kg_mission::TimeWindow& window : mission.windows) {
    if (time_s >= window.begin_s) iri = window.iri;
  }
  return Iri(iri);
}

void WritePose(const AgentPose& pose, const Term& window,
               const kg_mission::Agent& agent,
               kg_core::Transaction* transaction) {
  Writer write(Ex("state/" + agent.id), transaction);
  write.Add(Iri(std::string(kg_core::kRdf) + "type"), Ex("AgentState"))
      .Add(Ex("id"), Literal(agent.id))
      .Add(Ex("forAgent"), Iri(agent.iri))
      .Add(Ex("forWindow"), window)
      .Add(Iri(std::string(kg_core::kGeo) + "asWKT"),
           Literal(kg_base::PointWkt(pose.position),
                   std::string(kg_core::kGeo) + "wktLiteral"))
      .Add(Ex("headingDeg"),
           kg_core::DoubleLiteral(kg_base::RadToDeg(pose.heading_rad)))
      .Add(ResultTime(), DateTime(pose.time_s))
      .Add(Ex("energyRemaining"),
           kg_core::DoubleLiteral(pose.energy_left_j / kg_base::kJoulesPerWh));
  if (pose.observed) {
    write.Add(kg_core::Prov("wasAttributedTo"), Iri(agent.iri));
  } else {
    write.Add(kg_core::Prov("wasDerivedFrom"), Iri(agent.start_iri));
  }
}

}  // namespace

MissionState LoadState(const GraphView& view) {
  MissionState state;
  const auto folder = Read(view, StateNode(), Ex("missionFolder"));
  if (folder) state.mission_folder = folder->text;
  state.cycle = Count(view, "cycle");
  state.plan_run = Count(view, "planRun");
  state.mission_time_s = Time(view, StateNode(), Ex("missionTime"));
  const auto ended = Read(view, StateNode(), Ex("ended"));
  state.ended = ended && ended->text == "true";
  for (const Term& node : kg_core::Subjects(
           view, kg_core::kStateGraph, Iri(std::string(kg_core::kRdf) + "type"),
           Ex("AgentState"))) {
    const auto id = Read(view, node, Ex("id"));
    if (id) state.poses[id->text] = ReadPose(view, node);
  }
  return state;
}

void SaveState(const MissionState& state, const kg_mission::Mission& mission,
               kg_core::Transaction& transaction) {
  const Term graph = Iri(kg_core::kStateGraph);
  transaction.RemoveMatching(nullptr, nullptr, nullptr, graph);
  Writer write(StateNode(), &transaction);
  write.Add(Iri(std::string(kg_core::kRdf) + "type"), Ex("MissionState"))
      .Add(Ex("missionFolder"), Literal(state.mission_folder))
      .Add(Ex("cycle"),
           kg_core::IntegerLiteral(static_cast<long long>(state.cycle)))
      .Add(Ex("planRun"),
           kg_core::IntegerLiteral(static_cast<long long>(state.plan_run)))
      .Add(Ex("missionTime"), DateTime(state.mission_time_s))
      .Add(Ex("ended"), kg_core::BooleanLiteral(state.ended));
  if (state.plan_run > 0) {
    write.Add(Ex("currentPlan"), PlanRunNode(state.plan_run));
  }
  for (const kg_mission::Agent& agent : mission.agents) {
    const auto pose = state.poses.find(agent.id);
    if (pose != state.poses.end()) {
      WritePose(pose->second, WindowAt(mission, pose->second.time_s), agent,
                &transaction);
    }
  }
}

kg_core::Dataset CurrentDataset(const GraphView& view) {
  const std::uint64_t run = Count(view, "planRun");
  return kg_core::DefaultDataset(run == 0 ? std::nullopt
                                          : std::optional(PlanGraph(run).text));
}

}  // namespace kg_engine
