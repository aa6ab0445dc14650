// Seam rules and coordination rules <-> messages. Every received number is
// checked: kg_base::InputError names the field.

#ifndef KG_ROS_CONVERSION_RULES_CONVERSION_H_
#define KG_ROS_CONVERSION_RULES_CONVERSION_H_

#include <cstdint>
#include <string>
#include <vector>

#include "kg_compiler/compile/mission_compiler.h"
#include "kg_compiler/control_plane/seam_rules.h"
#include "kg_engine/planning/team_selector.h"
#include "kg_mission/mission/mission.h"
#include "kg_msgs/CoordinationRules.h"
#include "kg_msgs/SeamRules.h"
#include "kg_msgs/WindowInfo.h"
#include "kg_selector/paths/conflict.h"

namespace kg_ros {

kg_msgs::WindowInfo ToMessage(const kg_mission::TimeWindow& window);

kg_msgs::SeamRules ToMessage(const kg_compiler::SeamRules& rules,
                             std::uint64_t cycle);
kg_compiler::SeamRules FromMessage(const kg_msgs::SeamRules& message);

struct Coordination {
  std::uint64_t world_version = 0;
  std::uint64_t cycle = 0;
  std::vector<std::string> agents;      // ex:id.
  std::vector<double> energy_budget_j;  // Energy budget of each agent [J].
  std::vector<kg_mission::TimeWindow> windows;  // Windows to be planned.
  kg_compiler::CoordinationRules rules;
};
Coordination CoordinationOf(const kg_compiler::Compilation& compilation,
                            std::uint64_t cycle);
kg_msgs::CoordinationRules ToMessage(const Coordination& coordination);
kg_selector::TeamRules FromMessage(const kg_msgs::CoordinationRules& message);
// Rules with their agents, windows and cycle.
kg_engine::TeamTask ToTask(const kg_msgs::CoordinationRules& message);

}  // namespace kg_ros

#endif  // KG_ROS_CONVERSION_RULES_CONVERSION_H_
