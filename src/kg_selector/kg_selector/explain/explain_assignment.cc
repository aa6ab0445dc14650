#include <utility>

#include "kg_base/common/join_strings.h"
#include "kg_base/geo/wkt.h"
#include "kg_compiler/explain/explain_seam.h"
#include "kg_compiler/explain/explain_tensor.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_selector/explain/explain_plan.h"
#include "kg_selector/explain/path_terms.h"
#include "kg_selector/explain/why_not.h"
#include "kg_selector/paths/churn.h"

namespace kg_selector {
namespace {

using kg_compiler::Explanation;
using kg_compiler::Facts;
using kg_compiler::Short;
using kg_compiler::operator+;
using kg_core::AbbreviateIri;
using kg_mission::Agent;

std::string WindowName(int window) {
  return "window " + std::to_string(window);
}

std::string PlannedAround(const PlannedWorld& world, const Agent& agent) {
  const std::string names = kg_base::JoinStrings(
      CommittedBefore(world, agent.iri), ", ",
      [](const Pathlet& other) { return AbbreviateIri(other.agent); });
  return names.empty() ? " It was chosen first, before all others."
                       : " It was planned around " + names + ".";
}

std::string RunnerUp(const PlannedWorld& world, const TeamMember& member,
                     const Pathlet& path) {
  const FoundPath next = FindBest(world, member, {{}, &path});
  if (!next.pathlet) return " There is no other path.";
  const Explanation margin = Difference(world, member, path, *next.pathlet);
  std::string text =
      " The next best path is worth " + Short(margin.value) + " less";
  for (const auto& part : margin.parts) {
    text += (&part == &margin.parts.front() ? " (" : "; ") + part.text;
  }
  return text + (margin.parts.empty() ? "." : ").") +
         (next.proven ? "" : " The search for it was cut short.");
}

class StepExplainer {
 public:
  StepExplainer(const PlannedWorld& world, const TeamMember& member,
                const Pathlet& path, std::size_t stage)
      : world_(world),
        member_(member),
        agent_(FindAgent(world, path.agent)),
        path_(path),
        stage_(stage),
        visit_(path.visits.at(stage)),
        facts_(world.facts()) {}

  Explanation Explain() {
    AddScores();
    AddEvents();
    AddSeam();
    AddChurn();
    return std::move(explanation_);
  }

 private:
  const kg_mission::TimeWindow& window() const {
    return world_.compilation->mission.windows.at(visit_.window);
  }

  // Residual: tensors are float32, and the waypoint search rounds its sums.
  void AddScores() {
    for (const int stop : StopsOf(visit_)) {
      AddScore(member_.graphs[stage_].waypoints.at(stop));
    }
  }

  void AddScore(const kg_compiler::Waypoint& waypoint) {
    const auto inputs = kg_compiler::FindTensorInputs(*world_.compilation,
                                                      agent_, visit_.window);
    const Explanation score = kg_compiler::TensorExplainer(inputs, facts_)
                                  .ExplainSum(waypoint.footprint);
    const std::string cells =
        " (" + std::to_string(waypoint.footprint.size()) + " cells" +
        (visit_.via.empty()
             ? ""
             : " around waypoint " + std::to_string(waypoint.id)) +
        ")";
    // Sum over the footprint's cells, term by term.
    for (auto part : score.parts) {
      part.text += cells;
      explanation_.parts.push_back(std::move(part));
    }
    explanation_.AddIfAny({waypoint.score - score.Sum(), "rounding",
                           facts_.Quote({agent_.iri, {"ex:usesPolicy"}}),
                           "rounding: tensors are kept in single precision"});
    explanation_.value += waypoint.score;
  }

  void AddEvents() {
    const double w = window().confidence;
    for (const std::string& iri : visit_.events) {
      const kg_mission::Event* event = FindEvent(world_, iri);
      if (event == nullptr) continue;
      const std::string name = AbbreviateIri(iri);
      const Facts facts = facts_.Event(iri);
      explanation_.value += event->value * w;
      explanation_.parts.push_back({event->value, "event(" + name + ")", facts,
                                    "event: a visit of " + name});
      explanation_.AddIfAny({event->value * w - event->value,
                             "w_t event(" + name + ")",
                             facts + facts_.Window(window(), {"ex:confidence"}),
                             "confidence of the window: times " + Short(w)});
    }
  }

  void AddSeam() {
    const Explanation seam = kg_compiler::ExplainSeam(
        kg_compiler::FindSeamContext(*world_.compilation, agent_, member_.rules,
                                     visit_.window),
        EdgeTaken(member_, path_, stage_), facts_);
    for (auto part : seam.parts) {
      part.value = -part.value;
      part.term = "-" + part.term;
      explanation_.parts.push_back(std::move(part));
    }
    explanation_.value -= seam.value;
  }

  void AddChurn() {
    const double cost =
        ChurnCost(member_.rules, visit_.window, visit_.position);
    explanation_.AddIfAny({-cost, "-churn",
                           facts_.Policy(agent_, {"ex:churnWeight"}),
                           "churn: it is not where the plan in force ends"});
    explanation_.value -= cost;
  }

  const PlannedWorld& world_;
  const TeamMember& member_;
  const Agent& agent_;
  const Pathlet& path_;
  std::size_t stage_;
  const Visit& visit_;
  kg_compiler::CitedFacts facts_;
  Explanation explanation_;
};

Explanation ExplainPath(const PlannedWorld& world, const TeamMember& member,
                        const Pathlet& path) {
  Explanation explanation;
  explanation.value = Sum(ListTerms(world, member, path));
  explanation.parts = PathContributions(world, member, path);
  explanation.text = "The path of " + member.rules.agent_id + " through " +
                     std::to_string(path.visits.size()) + " windows is worth " +
                     Short(explanation.value) + ".";
  return explanation;
}

std::string ByWay(const Visit& visit) {
  std::string text;
  for (const int stop : WaypointsVia(visit)) {
    text += (text.empty() ? ", by way of " : ", ") + std::to_string(stop);
  }
  return text;
}

std::string StepText(const Agent& agent, const Visit& visit, double value) {
  return agent.id + " goes to waypoint " + std::to_string(visit.waypoint) +
         ", " + kg_base::PointWkt(visit.position) + ", in " +
         WindowName(visit.window) + ByWay(visit) + ": this step is worth " +
         Short(value) + ".";
}

}  // namespace

Explanation ExplainAssignment(const PlannedWorld& world, const Agent& agent,
                              int window) {
  const Pathlet& path = NeedPath(world, agent);
  const TeamMember& member = FindMember(world, agent);
  Explanation explanation;
  // Without a window: explain the whole path.
  if (window < 0) {
    explanation = ExplainPath(world, member, path);
  } else {
    const std::size_t stage = FindStage(member, window);
    explanation = StepExplainer(world, member, path, stage).Explain();
    explanation.text =
        StepText(agent, path.visits.at(stage), explanation.value);
  }
  explanation.unit = "reward";
  for (const std::string& fact : world.facts().Policy(agent, {})) {
    explanation.text += " It follows from " + fact + ".";
  }
  explanation.text +=
      PlannedAround(world, agent) + RunnerUp(world, member, path);
  return explanation;
}

}  // namespace kg_selector
