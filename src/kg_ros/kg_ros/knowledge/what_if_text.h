// A what-if's answer for a person.

#ifndef KG_ROS_KNOWLEDGE_WHAT_IF_TEXT_H_
#define KG_ROS_KNOWLEDGE_WHAT_IF_TEXT_H_

#include <string>

#include "kg_msgs/WhatIfResponse.h"

namespace kg_ros {

// Lines that say what would change, or why the question was refused; then what
// `answer.text` holds already (the query's table), if anything.
std::string WhatIfText(const kg_msgs::WhatIfResponse& answer);

}  // namespace kg_ros

#endif  // KG_ROS_KNOWLEDGE_WHAT_IF_TEXT_H_
