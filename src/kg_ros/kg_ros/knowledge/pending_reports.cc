#include "kg_ros/knowledge/pending_reports.h"

#include <utility>

namespace kg_ros {
namespace {

using kg_msgs::UpdateReport;

std::string DirtyHash(const kg_compiler::Compilation& compilation,
                      const kg_compiler::DirtyArtifact& dirty) {
  for (const auto& tensor : compilation.tensors) {
    if (dirty.kind == "tensor" && tensor->agent_iri == dirty.agent &&
        tensor->window == dirty.window) {
      return tensor->hash;
    }
  }
  for (const auto& field : compilation.fields) {
    if (dirty.kind == "work_field" && field->window == dirty.window) {
      return field->hash;
    }
  }
  return "";
}

}  // namespace

std::vector<kg_msgs::DirtyArtifact> DirtyMessages(
    const kg_compiler::Compilation& compilation) {
  std::vector<kg_msgs::DirtyArtifact> messages;
  for (const kg_compiler::DirtyArtifact& dirty : compilation.dirty) {
    kg_msgs::DirtyArtifact message;
    message.kind = dirty.kind;
    const kg_core::Agent* agent = compilation.mission.FindAgent(dirty.agent);
    message.agent = agent == nullptr ? "" : agent->id;
    message.window = dirty.window;
    message.hash = DirtyHash(compilation, dirty);
    messages.push_back(message);
  }
  return messages;
}

kg_msgs::StageTime Stage(const std::string& name, double seconds,
                         std::size_t count) {
  kg_msgs::StageTime stage;
  stage.stage = name;
  stage.seconds = seconds;
  stage.count = static_cast<unsigned>(count);
  return stage;
}

void PendingReports::Compiled(const kg_compiler::Compilation& compilation,
                              const double compile_s, const double publish_s) {
  for (UpdateReport& report : reports_) {
    if (!report.dirty.empty()) continue;
    report.dirty = DirtyMessages(compilation);
    report.stages.push_back(
        Stage("compile", compile_s, compilation.dirty.size()));
    report.stages.push_back(Stage("publish", publish_s, 0));
  }
}

std::vector<UpdateReport> PendingReports::Answer(
    const kg_msgs::Assignments& plan, const double commit_s) {
  for (UpdateReport& report : reports_) {
    report.plan_status = plan.unassigned.empty() ? UpdateReport::PLAN_OK
                                                 : UpdateReport::PLAN_FAILED;
    report.warnings.insert(report.warnings.end(), plan.unassigned.begin(),
                           plan.unassigned.end());
    report.stages.insert(report.stages.end(), plan.stages.begin(),
                         plan.stages.end());
    report.stages.push_back(Stage("commit", commit_s, 1));
  }
  return std::exchange(reports_, {});
}

std::vector<UpdateReport> PendingReports::Fail(const std::string& why) {
  for (UpdateReport& report : reports_) {
    report.plan_status = UpdateReport::PLAN_FAILED;
    report.warnings.push_back(why);
  }
  return std::exchange(reports_, {});
}

}  // namespace kg_ros
