// The difference between the plans of two worlds, as kg/what_if answers it.

#ifndef KG_ROS_KNOWLEDGE_PLAN_CHANGE_H_
#define KG_ROS_KNOWLEDGE_PLAN_CHANGE_H_

#include "kg_msgs/WhatIfResponse.h"
#include "kg_ros/knowledge/edge_prices.h"

namespace kg_ros {

// Fills dirty, plan, reward_change, energy_change_j, paths, edges... and
// changed_edges of `answer`.
void ComparePlans(const PlannedWorld& now, const PlannedWorld& then,
                  const EdgePrices& prices, kg_msgs::WhatIfResponse* answer);

}  // namespace kg_ros

#endif  // KG_ROS_KNOWLEDGE_PLAN_CHANGE_H_
