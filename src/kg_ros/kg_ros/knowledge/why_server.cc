#include "kg_ros/knowledge/why_server.h"

#include <exception>
#include <string>

#include "kg_base/common/input_error.h"
#include "kg_engine/server/mission_server.h"
#include "kg_ros/base/names.h"
#include "kg_ros/conversion/answer_conversion.h"
#include "kg_selector/explain/explain_plan.h"

namespace kg_ros {

using kg_base::InputError;

WhyServer::WhyServer(const ros::NodeHandle& node,
                     const kg_engine::MissionServer* server)
    : node_(node), server_(server), spinner_(1, &queue_) {
  node_.setCallbackQueue(&queue_);
  service_ = node_.advertiseService(kWhyService, &WhyServer::Handle, this);
  spinner_.start();
}

WhyServer::~WhyServer() { spinner_.stop(); }

bool WhyServer::Handle(kg_msgs::Why::Request& request,
                       kg_msgs::Why::Response& response) {
  try {
    const kg_selector::PlanQuestion question = FromMessage(request);
    const auto world = question.what == kg_selector::QuestionKind::kTensorCell
                           ? archive_.Newest()
                           : archive_.Planned();
    if (!world) throw InputError("there is no plan yet");
    const std::uint64_t version = world->compilation->world_version;
    response.world_version = version;
    kg_compiler::Explanation explanation =
        kg_selector::Explain(*world, question);
    const std::uint64_t now = server_->Read()->world_version();
    if (now != version) {
      explanation.text += " The answer is of world version " +
                          std::to_string(version) + "; the facts are at " +
                          std::to_string(now) + " and the plan is stale.";
    }
    response = ToMessage(explanation);
    response.world_version = version;
    // Includes errors in planners' results.
  } catch (const std::exception& error) {
    response.error = error.what();
  }
  return true;
}

}  // namespace kg_ros
