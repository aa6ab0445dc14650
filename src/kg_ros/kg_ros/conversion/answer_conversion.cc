#include "kg_ros/conversion/answer_conversion.h"

#include <iterator>
#include <string>

#include "kg_base/common/input_error.h"
#include "kg_base/common/units.h"
#include "kg_core/sparql/results.h"
#include "kg_ros/conversion/fact_conversion.h"
#include "kg_ros/conversion/message_units.h"
#include "kg_ros/conversion/plan_conversion.h"

namespace kg_ros {
namespace {

kg_msgs::PathChange ToMessage(const kg_engine::PathChange& change) {
  kg_msgs::PathChange message;
  message.agent = change.agent;
  message.agent_iri = change.agent_iri;
  message.changed = change.changed;
  message.infeasible = change.infeasible;
  message.energy_needed_j = change.energy_needed_j;
  message.energy_budget_j = change.energy_budget_j;
  message.before = kg_ros::ToMessage(change.before);
  message.after = kg_ros::ToMessage(change.after);
  message.unassigned = change.unassigned;
  return message;
}

kg_msgs::EdgeChange ToMessage(const kg_engine::EdgeChange& change) {
  kg_msgs::EdgeChange message;
  message.agent = change.agent;
  message.window = change.window;
  message.edge = change.edge;
  message.from_lon_rad = kg_base::DegToRad(change.from.lon_deg);
  message.from_lat_rad = kg_base::DegToRad(change.from.lat_deg);
  message.to_lon_rad = kg_base::DegToRad(change.to.lon_deg);
  message.to_lat_rad = kg_base::DegToRad(change.to.lat_deg);
  message.infeasible = change.infeasible;
  message.before = kg_ros::ToMessage(change.before);
  message.after = kg_ros::ToMessage(change.after);
  return message;
}

std::string RowsJson(const std::vector<std::string>& variables,
                     const kg_core::Rows& rows) {
  kg_core::QueryResult result;
  result.variables = variables;
  result.rows = rows;
  return kg_core::ToJson(result);
}

}  // namespace

std::vector<kg_msgs::DirtyArtifact> ToMessage(
    const std::vector<kg_engine::RecompiledArtifact>& artifacts) {
  std::vector<kg_msgs::DirtyArtifact> messages;
  for (const kg_engine::RecompiledArtifact& artifact : artifacts) {
    messages.emplace_back();
    messages.back().kind = artifact.kind;
    messages.back().agent = artifact.agent;
    messages.back().window = artifact.window;
    messages.back().hash = artifact.hash;
  }
  return messages;
}

kg_engine::WhatIfQuestion FromMessage(const kg_msgs::WhatIf::Request& request) {
  return {FromMessage(request.update), request.query, request.time_limit_s};
}

kg_msgs::WhatIf::Response ToMessage(const kg_engine::WhatIfAnswer& answer) {
  kg_msgs::WhatIf::Response message;
  message.ok = answer.ok;
  message.errors = answer.errors;
  message.world_version = answer.world_version;
  message.dirty = ToMessage(answer.dirty);
  message.plan = ToMessage(answer.plan);
  message.reward_change = answer.reward_change;
  message.energy_change_j = answer.energy_change_j;
  message.result = answer.result;
  message.text = answer.text;
  for (const auto& change : answer.paths) {
    message.paths.push_back(ToMessage(change));
  }
  message.edges = static_cast<unsigned>(answer.edges);
  message.edges_infeasible = static_cast<unsigned>(answer.edges_infeasible);
  message.edges_dearer = static_cast<unsigned>(answer.edges_dearer);
  message.edges_cheaper = static_cast<unsigned>(answer.edges_cheaper);
  for (const auto& change : answer.changed_edges) {
    message.changed_edges.push_back(ToMessage(change));
  }
  message.stages = ToMessage(answer.stages);
  return message;
}

kg_msgs::Check::Response ToMessage(const kg_engine::CheckAnswer& answer) {
  kg_msgs::Check::Response message;
  message.ok = answer.ok;
  message.world_version = answer.world_version;
  message.compared = static_cast<unsigned>(answer.compared);
  message.differs = answer.differs;
  message.errors = answer.errors;
  message.compile_s = answer.compile_s;
  message.total_s = answer.total_s;
  message.text = answer.text;
  return message;
}

kg_engine::ExportRequest FromMessage(const kg_msgs::Export::Request& request) {
  return {request.format, request.graphs, request.path};
}

kg_msgs::Export::Response ToMessage(const kg_engine::ExportAnswer& answer) {
  kg_msgs::Export::Response message;
  message.ok = answer.ok;
  message.error = answer.error;
  message.world_version = answer.world_version;
  message.data = answer.data;
  return message;
}

kg_selector::PlanQuestion FromMessage(const kg_msgs::Why::Request& request) {
  using kg_selector::QuestionKind;
  constexpr QuestionKind kKinds[] = {
      QuestionKind::kAssignment, QuestionKind::kTensorCell,
      QuestionKind::kEdge,       QuestionKind::kRejection,
      QuestionKind::kWaypoint,   QuestionKind::kEvent,
      QuestionKind::kPlace};
  if (request.what >= std::size(kKinds)) {
    throw kg_base::InputError("Why.what: expected 0 to " +
                              std::to_string(std::size(kKinds) - 1) + ", not " +
                              std::to_string(request.what));
  }
  kg_selector::PlanQuestion question;
  question.what = kKinds[request.what];
  question.agent = request.agent;
  question.window = request.window;
  question.from = static_cast<int>(request.from);
  question.to = static_cast<int>(request.to);
  question.via.assign(request.via.begin(), request.via.end());
  question.place = GetPosition(request);
  question.id = request.id;
  return question;
}

kg_msgs::Why::Response ToMessage(const kg_compiler::Explanation& explanation) {
  kg_msgs::Why::Response message;
  message.ok = true;
  message.value = explanation.value;
  message.unit = explanation.unit;
  message.verdict = explanation.verdict;
  for (const kg_compiler::Contribution& part : explanation.parts) {
    message.facts.push_back(kg_compiler::JoinFacts(part.facts));
    message.contributions.push_back(part.value);
  }
  message.text = kg_compiler::ToText(explanation);
  message.json = kg_compiler::ToJson(explanation);
  return message;
}

kg_msgs::WatchedAnswer ToMessage(const kg_core::WatchedAnswer& answer) {
  const std::vector<std::string>& variables = answer.answer.variables;
  kg_msgs::WatchedAnswer message;
  message.id = answer.id;
  message.world_version = answer.world_version;
  message.first = static_cast<unsigned char>(answer.is_first);
  message.error = answer.error;
  message.result = kg_core::ToJson(answer.answer);
  message.added = RowsJson(variables, answer.added);
  message.removed = RowsJson(variables, answer.removed);
  return message;
}

}  // namespace kg_ros
