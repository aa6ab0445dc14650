// Waypoint graphs, pathlets, candidates, requests and plans <-> messages. Every
// received number used in planning is checked: kg_base::InputError names the
// field.

#ifndef KG_ROS_CONVERSION_PLAN_CONVERSION_H_
#define KG_ROS_CONVERSION_PLAN_CONVERSION_H_

#include <string>
#include <vector>

#include "kg_compiler/control_plane/edge_cost.h"
#include "kg_compiler/traversal/traversal.h"
#include "kg_engine/planning/agent_graph.h"
#include "kg_msgs/Assignments.h"
#include "kg_msgs/Candidates.h"
#include "kg_msgs/EdgeCost.h"
#include "kg_msgs/NavGraph.h"
#include "kg_msgs/Pathlet.h"
#include "kg_msgs/Rejections.h"
#include "kg_msgs/RoundRequest.h"
#include "kg_msgs/StageTime.h"
#include "kg_msgs/TimedPoint.h"
#include "kg_selector/paths/pathlet.h"
#include "kg_selector/team/agent_candidates.h"
#include "kg_selector/team/committed_plan.h"
#include "kg_selector/team/round_request.h"

namespace kg_ros {

std::vector<kg_msgs::TimedPoint> ToMessage(
    const std::vector<kg_compiler::TimedPoint>& track);
// Throws kg_base::InputError if times do not ascend or are not finite.
std::vector<kg_compiler::TimedPoint> FromMessage(
    const std::vector<kg_msgs::TimedPoint>& message);

kg_msgs::EdgeCost ToMessage(const kg_compiler::EdgeCost& cost);
kg_compiler::EdgeCost FromMessage(const kg_msgs::EdgeCost& message);

kg_msgs::StageTime ToMessage(const kg_selector::StageTime& stage);
std::vector<kg_msgs::StageTime> ToMessage(
    const std::vector<kg_selector::StageTime>& stages);

kg_msgs::NavGraph ToMessage(const kg_engine::AgentGraph& graph);
// Throws kg_base::InputError if ids are not 0, 1, 2, ... in order, or numbers
// are not finite.
kg_engine::AgentGraph FromMessage(const kg_msgs::NavGraph& message);

kg_msgs::Pathlet ToMessage(const kg_selector::Pathlet& pathlet);
kg_selector::Pathlet FromMessage(const kg_msgs::Pathlet& message,
                                 const std::string& agent);

kg_msgs::Candidates ToMessage(const kg_selector::AgentCandidates& candidates);
kg_selector::AgentCandidates FromMessage(const kg_msgs::Candidates& message);

kg_msgs::RoundRequest ToMessage(const kg_selector::RoundRequest& request);
kg_selector::RoundRequest FromMessage(const kg_msgs::RoundRequest& message);

kg_msgs::Rejections ToMessage(const kg_selector::RunEnd& end);
kg_selector::RunEnd FromMessage(const kg_msgs::Rejections& message);

kg_msgs::Assignments ToMessage(const kg_selector::CommittedPlan& plan);
kg_selector::CommittedPlan FromMessage(const kg_msgs::Assignments& message);

}  // namespace kg_ros

#endif  // KG_ROS_CONVERSION_PLAN_CONVERSION_H_
