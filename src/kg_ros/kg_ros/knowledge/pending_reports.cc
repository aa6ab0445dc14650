#include "kg_ros/knowledge/pending_reports.h"

#include <utility>

#include "kg_engine/facts/recompiled_artifact.h"
#include "kg_ros/conversion/answer_conversion.h"
#include "kg_ros/conversion/plan_conversion.h"

namespace kg_ros {

using kg_msgs::UpdateReport;

void PendingReports::Compiled(const kg_compiler::Compilation& compilation,
                              const double compile_s, const double publish_s) {
  for (UpdateReport& report : reports_) {
    if (!report.dirty.empty()) continue;
    report.dirty = ToMessage(kg_engine::ListRecompiled(compilation));
    report.stages.push_back(ToMessage(kg_selector::StageTime{
        "compile", compile_s, compilation.dirty.size()}));
    report.stages.push_back(
        ToMessage(kg_selector::StageTime{"publish", publish_s, 0}));
  }
}

void PendingReports::Warn(const std::vector<std::string>& warnings) {
  for (UpdateReport& report : reports_) {
    report.warnings.insert(report.warnings.end(), warnings.begin(),
                           warnings.end());
  }
}

std::vector<UpdateReport> PendingReports::Answer(
    const kg_selector::CommittedPlan& plan, const double commit_s) {
  for (UpdateReport& report : reports_) {
    report.plan_status = plan.unassigned.empty() ? UpdateReport::PLAN_OK
                                                 : UpdateReport::PLAN_FAILED;
    for (const std::string& line : kg_selector::UnassignedLines(plan)) {
      report.warnings.push_back(line);
    }
    for (const kg_selector::StageTime& stage : plan.stages) {
      report.stages.push_back(ToMessage(stage));
    }
    report.stages.push_back(
        ToMessage(kg_selector::StageTime{"commit", commit_s, 1}));
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
