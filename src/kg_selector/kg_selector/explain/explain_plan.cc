#include "kg_selector/explain/explain_plan.h"

#include <cstdlib>

#include "kg_base/common/input_error.h"
#include "kg_base/geo/wkt.h"
#include "kg_compiler/explain/explain_seam.h"
#include "kg_compiler/explain/explain_tensor.h"
#include "kg_selector/explain/why_not.h"

namespace kg_selector {
namespace {

using kg_base::InputError;
using kg_compiler::Explanation;
using kg_compiler::Short;
using kg_mission::Agent;

std::string PlanWindowName(int window) {
  return "window " + std::to_string(window);
}

std::string ByWay(const std::vector<int>& via) {
  std::string text;
  for (const int stop : via) {
    text += (text.empty() ? " by way of " : ", ") + std::to_string(stop);
  }
  return text;
}

Explanation ExplainCell(const PlannedWorld& world, const Agent& agent,
                        const PlanQuestion& question) {
  const auto inputs =
      kg_compiler::FindTensorInputs(*world.compilation, agent, question.window);
  const auto cell = inputs.rasters->grid.CellAt(question.place);
  if (!cell) {
    throw InputError(kg_base::PointWkt(question.place) +
                     " lies outside of the grid");
  }
  const kg_compiler::CitedFacts facts = world.facts();
  return kg_compiler::TensorExplainer(inputs, facts).ExplainCell(*cell);
}

const kg_compiler::TraverseEdge& EdgeAsked(const TeamMember& member,
                                           const PlanQuestion& question) {
  const kg_compiler::NavGraph& graph =
      member.graphs[FindStage(member, question.window)];
  const auto* edge =
      kg_compiler::FindEdge(graph, question.from, question.to, question.via);
  if (edge) return *edge;
  throw InputError(
      "no edge leads from waypoint " + std::to_string(question.from) + " to " +
      std::to_string(question.to) + ByWay(question.via) + " in " +
      PlanWindowName(question.window) + " of " + member.rules.agent_id +
      ": it has " + std::to_string(graph.waypoints.size()) + " waypoints and " +
      std::to_string(graph.edges.size()) + " edges");
}

Explanation ExplainEdge(const PlannedWorld& world, const Agent& agent,
                        const PlanQuestion& question) {
  const TeamMember& member = FindMember(world, agent);
  const kg_compiler::TraverseEdge& edge = EdgeAsked(member, question);
  const kg_compiler::CitedFacts facts = world.facts();
  Explanation explanation = kg_compiler::ExplainSeam(
      kg_compiler::FindSeamContext(*world.compilation, agent, member.rules,
                                   question.window),
      edge, facts);
  explanation.text =
      "The way of " + agent.id + " from waypoint " + std::to_string(edge.from) +
      " to " + std::to_string(edge.to) + ByWay(edge.via) + " in " +
      PlanWindowName(question.window) + " costs " + Short(explanation.value) +
      ": " + Short(edge.flight.travel_s / 3600.0) + " h, " +
      Short(edge.flight.energy_j / 3600.0) + " Wh.";
  return explanation;
}

std::size_t RejectionNumber(const PlannedWorld& world, const std::string& id) {
  const std::string digits = id.substr(id.find_last_of('/') + 1);
  char* end = nullptr;
  const unsigned long number = std::strtoul(digits.c_str(), &end, 10);
  const bool is_number = !digits.empty() && *end == '\0' && digits[0] != '-';
  const std::size_t count = world.plan.rejections.size();
  if (is_number && number < count) return number;
  throw InputError("rejection '" + id + "' is not known: the plan has " +
                   std::to_string(count) +
                   (count == 0 ? "" : ", numbered from 0"));
}

void NeedPlan(const PlannedWorld& world) {
  if (!world.has_plan) throw InputError("there is no plan yet");
}

}  // namespace

Explanation Explain(const PlannedWorld& world, const PlanQuestion& question) {
  if (question.what != QuestionKind::kTensorCell) NeedPlan(world);
  if (question.what == QuestionKind::kRejection) {
    return ExplainRejection(world, RejectionNumber(world, question.id));
  }
  const Agent& agent = FindAgent(world, question.agent);
  switch (question.what) {
    case QuestionKind::kAssignment:
      return ExplainAssignment(world, agent, question.window);
    case QuestionKind::kTensorCell:
      return ExplainCell(world, agent, question);
    case QuestionKind::kEdge:
      return ExplainEdge(world, agent, question);
    case QuestionKind::kWaypoint:
      return WhyNotWaypoint(world, agent, {question.window, question.to});
    case QuestionKind::kEvent:
      return WhyNotEvent(world, agent, question.id, question.window);
    case QuestionKind::kPlace:
      return WhyNotPlace(world, agent, question.place, question.window);
    case QuestionKind::kRejection:
      break;
  }
  throw InputError("unknown question");
}

}  // namespace kg_selector
