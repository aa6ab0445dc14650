// Waypoint graphs, pathlets and tracks <-> messages.

#ifndef KG_ROS_CONVERSION_PLAN_CONVERSION_H_
#define KG_ROS_CONVERSION_PLAN_CONVERSION_H_

#include <cstdint>
#include <string>
#include <vector>

#include "kg_compiler/control_plane/nav_graphs.h"
#include "kg_compiler/control_plane/seam_rules.h"
#include "kg_compiler/traversal/traversal.h"
#include "kg_msgs/Assignments.h"
#include "kg_msgs/EdgeCost.h"
#include "kg_msgs/NavGraph.h"
#include "kg_msgs/Pathlet.h"
#include "kg_msgs/Rejection.h"
#include "kg_msgs/TimedPoint.h"
#include "kg_selector/paths/pathlet.h"
#include "kg_selector/team/plan_mission.h"
#include "kg_selector/team/team_plan.h"

namespace kg_ros {

std::vector<kg_msgs::TimedPoint> ToMessage(
    const std::vector<kg_compiler::TimedPoint>& track);
// Throws kg_core::InputError if times do not ascend or are not finite.
std::vector<kg_compiler::TimedPoint> FromMessage(
    const std::vector<kg_msgs::TimedPoint>& message);

kg_msgs::EdgeCost CostMessage(const kg_compiler::TraverseEdge& edge);
kg_msgs::NavGraph ToMessage(const kg_compiler::NavGraph& graph,
                            const kg_compiler::SeamRules& rules);

// The inverse. Throws kg_core::InputError if ids are not those of the order, or
// numbers are not finite.
kg_compiler::NavGraph FromMessage(const kg_msgs::NavGraph& message);

// With the cost of every seam, looked up in the graphs the path was made of.
kg_msgs::Pathlet ToMessage(const kg_selector::Pathlet& pathlet,
                           const kg_compiler::NavGraphs& graphs);
kg_selector::Pathlet FromMessage(const kg_msgs::Pathlet& message,
                                 const std::string& agent);

kg_msgs::Rejection ToMessage(const kg_selector::RejectedPath& rejection,
                             const std::string& agent_iri);
// The plan as the selector node commits it, but for header, versions, run and
// stages.
kg_msgs::Assignments ToMessage(const kg_selector::PlannedMission& planned);

// Where a track is at a time: before its begin its first point, after its end
// its last. The track must not be empty.
kg_core::LonLat PositionAt(const std::vector<kg_compiler::TimedPoint>& track,
                           double time_s);

}  // namespace kg_ros

#endif  // KG_ROS_CONVERSION_PLAN_CONVERSION_H_
