// Service requests to questions, and the engine's answers to responses.

#ifndef KG_ROS_CONVERSION_ANSWER_CONVERSION_H_
#define KG_ROS_CONVERSION_ANSWER_CONVERSION_H_

#include <vector>

#include "kg_compiler/explain/explanation.h"
#include "kg_core/watch/watch_list.h"
#include "kg_engine/export/export_server.h"
#include "kg_engine/facts/recompiled_artifact.h"
#include "kg_engine/server/world_check.h"
#include "kg_engine/what_if/what_if.h"
#include "kg_msgs/Check.h"
#include "kg_msgs/DirtyArtifact.h"
#include "kg_msgs/Export.h"
#include "kg_msgs/WatchedAnswer.h"
#include "kg_msgs/WhatIf.h"
#include "kg_msgs/Why.h"
#include "kg_selector/explain/explain_plan.h"

namespace kg_ros {

std::vector<kg_msgs::DirtyArtifact> ToMessage(
    const std::vector<kg_engine::RecompiledArtifact>& artifacts);

kg_engine::WhatIfQuestion FromMessage(const kg_msgs::WhatIf::Request& request);
kg_msgs::WhatIf::Response ToMessage(const kg_engine::WhatIfAnswer& answer);

kg_msgs::Check::Response ToMessage(const kg_engine::CheckAnswer& answer);

kg_engine::ExportRequest FromMessage(const kg_msgs::Export::Request& request);
kg_msgs::Export::Response ToMessage(const kg_engine::ExportAnswer& answer);

// Throws kg_base::InputError for an unknown kind of question.
kg_selector::PlanQuestion FromMessage(const kg_msgs::Why::Request& request);
// All fields but the world version.
kg_msgs::Why::Response ToMessage(const kg_compiler::Explanation& explanation);

// Rows as SPARQL results JSON; all fields but the time.
kg_msgs::WatchedAnswer ToMessage(const kg_core::WatchedAnswer& answer);

}  // namespace kg_ros

#endif  // KG_ROS_CONVERSION_ANSWER_CONVERSION_H_
