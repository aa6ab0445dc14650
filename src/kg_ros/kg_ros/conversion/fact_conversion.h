// Fact updates and their reports <-> messages.

#ifndef KG_ROS_CONVERSION_FACT_CONVERSION_H_
#define KG_ROS_CONVERSION_FACT_CONVERSION_H_

#include "kg_mission/mission/stage_update.h"
#include "kg_msgs/FactUpdate.h"

namespace kg_ros {

kg_core::FactUpdate FromMessage(const kg_msgs::FactUpdate& message);

}  // namespace kg_ros

#endif  // KG_ROS_CONVERSION_FACT_CONVERSION_H_
