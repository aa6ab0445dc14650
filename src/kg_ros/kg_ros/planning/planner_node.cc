#include "kg_ros/planning/planner_node.h"

#include <functional>
#include <memory>
#include <string>

#include "kg_base/common/input_error.h"
#include "kg_engine/planning/agent_planner.h"
#include "kg_msgs/Candidates.h"
#include "kg_msgs/MissionTensor.h"
#include "kg_msgs/NavGraph.h"
#include "kg_msgs/Rejections.h"
#include "kg_msgs/RoundRequest.h"
#include "kg_msgs/SeamRules.h"
#include "kg_msgs/WorkField.h"
#include "kg_ros/base/names.h"
#include "kg_ros/base/parameter_reader.h"
#include "kg_ros/base/run_node.h"
#include "kg_ros/conversion/plan_conversion.h"
#include "kg_ros/conversion/rules_conversion.h"
#include "kg_ros/conversion/tensor_conversion.h"
#include "ros/callback_queue.h"
#include "ros/ros.h"

namespace kg_ros {
namespace {

constexpr double kRasterPatience_s =
    2.0;  // Wait for rasters named by the rules.

class PlannerNode {
 public:
  PlannerNode(const ros::NodeHandle& node, const std::string& agent)
      : node_(node), agent_(agent) {
    nav_graphs_ = node_.advertise<kg_msgs::NavGraph>(kNavGraphsTopic, 64);
    candidates_ = node_.advertise<kg_msgs::Candidates>(
        kCandidatesTopic, 8,
        [this](const ros::SingleSubscriberPublisher& subscriber) {
          if (has_planned_) subscriber.publish(last_);
        });
    SubscribeRasters();
    rules_ = Subscribe<kg_msgs::SeamRules>(AgentTopic(agent_, kSeamRules), 1);
    rejections_ = Subscribe<kg_msgs::Rejections>(kRejectionsTopic, 8);
    requests_ = node_.subscribe(kRoundRequestsTopic, 8,
                                &PlannerNode::HandleRequest, this);
    patience_ = node_.createWallTimer(
        ros::WallDuration(kRasterPatience_s),
        [this](const ros::WallTimerEvent&) { AskAgain(); });
  }

  void Spin() {
    while (ros::ok()) {
      ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.05));
      if (planner_.IsDue() && planner_.IsComplete()) Plan();
    }
  }

 private:
  template <typename Message>
  ros::Subscriber Subscribe(const std::string& topic, unsigned queue) {
    const boost::function<void(const boost::shared_ptr<const Message>&)>
        handle = [this](const boost::shared_ptr<const Message>& message) {
          Guarded([&] { Take(*message); });
        };
    return node_.subscribe<Message>(topic, queue, handle);
  }

  void Take(const kg_msgs::SeamRules& message) {
    planner_.Take(FromMessage(message), message.cycle);
  }
  // The requests of this run are void, also one that is still on its way.
  void Take(const kg_msgs::Rejections& message) {
    planner_.Take(FromMessage(message));
  }
  void Take(const kg_msgs::MissionTensor& message) {
    if (planner_.HasTensor(message.window, message.hash)) return;
    planner_.Take(std::make_shared<const kg_compiler::MissionTensor>(
        FromMessage(message)));
  }
  void Take(const kg_msgs::WorkField& message) {
    if (planner_.HasField(message.window, message.hash)) return;
    planner_.Take(
        std::make_shared<const kg_compiler::WorkField>(FromMessage(message)));
  }

  void SubscribeRasters() {
    tensors_ = Subscribe<kg_msgs::MissionTensor>(AgentTopic(agent_, kTensors),
                                                 kAllWindows);
    fields_ = Subscribe<kg_msgs::WorkField>(kWorkFieldsTopic, kAllWindows);
  }

  // A raster message may be lost: resubscribing triggers sending all of them
  // again.
  void AskAgain() {
    if (!planner_.IsDue() || planner_.IsComplete()) {
      was_waiting_ = false;
      return;
    }
    if (was_waiting_) {
      ROS_WARN_STREAM("[plan] " << agent_ << " waits for " << planner_.Missing()
                                << ": asking again");
      SubscribeRasters();
    }
    was_waiting_ = true;
  }

  void Guarded(const std::function<void()>& work) {
    try {
      work();
    } catch (const kg_base::InputError& error) {
      ROS_ERROR_STREAM("[plan] " << agent_ << ": " << error.what());
    }
  }

  void Plan() {
    Guarded([this] {
      const kg_engine::PlannerAnswer answer = planner_.Plan();
      for (const kg_engine::AgentGraph& graph : answer.graphs) {
        nav_graphs_.publish(ToMessage(graph));
      }
      last_ = ToMessage(answer.candidates);
      has_planned_ = true;
      candidates_.publish(last_);
    });
    PlanAgain();  // A request may have arrived before the first plan.
  }

  void HandleRequest(const kg_msgs::RoundRequest& message) {
    Guarded([&] { asked_ = FromMessage(message); });
    PlanAgain();
  }

  void PlanAgain() {
    Guarded([this] {
      const auto answer = planner_.PlanAgain(asked_);
      if (answer) candidates_.publish(ToMessage(answer->candidates));
    });
  }

  ros::NodeHandle node_;
  std::string agent_;
  kg_engine::AgentPlanner planner_;
  ros::Publisher nav_graphs_;
  ros::Publisher candidates_;
  ros::Subscriber tensors_;
  ros::Subscriber fields_;
  ros::Subscriber rules_;
  ros::Subscriber rejections_;
  ros::Subscriber requests_;
  ros::WallTimer patience_;
  kg_selector::RoundRequest asked_;  // Last request.
  kg_msgs::Candidates last_;         // Candidates of round 0.
  bool has_planned_ = false;
  bool was_waiting_ = false;
};

}  // namespace

int RunPlannerNode(int argc, char** argv) {
  return RunNode(argc, argv, "planner", [](const ros::NodeHandle& own) {
    ParameterReader read(own);
    const std::string agent = read.Text("agent");
    read.RefuseTheRest();
    PlannerNode node(ros::NodeHandle(), agent);
    node.Spin();
  });
}

}  // namespace kg_ros
