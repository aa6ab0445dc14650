// Reports of fact updates that were accepted and wait for their plan. They
// gather what became dirty and how long each stage took, and are handed out
// once the plan answers for them, or could not be made.

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

  // Their facts are compiled. Several updates may share one compilation; one
  // that was abandoned for a newer update has said what was dirty already.
  void Compiled(const kg_compiler::Compilation& compilation, double compile_s,
                double publish_s);

  // All that wait, with the end of their story; then nothing waits.
  std::vector<kg_msgs::UpdateReport> Answer(
      const kg_selector::CommittedPlan& plan, double commit_s);
  std::vector<kg_msgs::UpdateReport> Fail(const std::string& why);

 private:
  std::vector<kg_msgs::UpdateReport> reports_;
};

}  // namespace kg_ros

#endif  // KG_ROS_KNOWLEDGE_PENDING_REPORTS_H_
