// Reports of accepted fact updates that wait for their plan. They collect dirty
// artifacts and stage durations, and are returned once a plan accounts for
// them, or planning has failed.

#ifndef KG_ROS_KNOWLEDGE_PENDING_REPORTS_H_
#define KG_ROS_KNOWLEDGE_PENDING_REPORTS_H_

#include <string>
#include <vector>

#include "kg_compiler/compile/mission_compiler.h"
#include "kg_msgs/UpdateReport.h"
#include "kg_selector/team/committed_plan.h"

namespace kg_ros {

class PendingReports {
 public:
  void Add(const kg_msgs::UpdateReport& report) { reports_.push_back(report); }

  // Adds the compilation of their facts. Several updates may share one
  // compilation; a compilation abandoned for a newer update has already
  // reported its dirty artifacts.
  void Compiled(const kg_compiler::Compilation& compilation, double compile_s,
                double publish_s);

  // Adds warnings to all pending reports.
  void Warn(const std::vector<std::string>& warnings);

  // Returns all pending reports with their result; none is pending afterwards.
  std::vector<kg_msgs::UpdateReport> Answer(
      const kg_selector::CommittedPlan& plan, double commit_s);
  std::vector<kg_msgs::UpdateReport> Fail(const std::string& why);

 private:
  std::vector<kg_msgs::UpdateReport> reports_;
};

}  // namespace kg_ros

#endif  // KG_ROS_KNOWLEDGE_PENDING_REPORTS_H_
