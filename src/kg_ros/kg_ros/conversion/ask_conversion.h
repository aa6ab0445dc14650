// What a team asks of its planners, round by round, <-> Rejections messages.

#ifndef KG_ROS_CONVERSION_ASK_CONVERSION_H_
#define KG_ROS_CONVERSION_ASK_CONVERSION_H_

#include <optional>
#include <string>

#include "kg_msgs/Rejections.h"
#include "kg_selector/paths/conflict.h"
#include "kg_selector/team/team_plan.h"

namespace kg_ros {

// Adds who is asked, and what for, to a message whose header is set.
void AddAsk(const std::string& agent, const kg_selector::PlanRequest& ask,
            const kg_selector::TeamRules& rules, kg_msgs::Rejections* message);

struct AskedOf {
  kg_selector::PlanRequest ask;
  double separation_m = 0.0;  // From those committed.
};
// What the message asks of an agent; nothing if it does not. Prices without an
// agent are for all. Throws kg_core::InputError if a price is not a finite
// number >= 0.
std::optional<AskedOf> AskOf(const kg_msgs::Rejections& message,
                             const std::string& agent);

}  // namespace kg_ros

#endif  // KG_ROS_CONVERSION_ASK_CONVERSION_H_
