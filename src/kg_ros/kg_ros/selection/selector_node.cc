#include "kg_ros/selection/selector_node.h"

#include <algorithm>
#include <functional>
#include <map>
#include <string>

#include "kg_base/common/input_error.h"
#include "kg_engine/planning/team_selector.h"
#include "kg_msgs/Assignments.h"
#include "kg_msgs/Candidates.h"
#include "kg_msgs/CoordinationRules.h"
#include "kg_msgs/Rejections.h"
#include "kg_msgs/RoundRequest.h"
#include "kg_msgs/World.h"
#include "kg_ros/base/names.h"
#include "kg_ros/base/parameter_reader.h"
#include "kg_ros/base/run_node.h"
#include "kg_ros/conversion/plan_conversion.h"
#include "kg_ros/conversion/rules_conversion.h"
#include "ros/file_log.h"
#include "ros/ros.h"
#include "ros/single_subscriber_publisher.h"

namespace kg_ros {
namespace {

class SelectorNode {
 public:
  SelectorNode(const ros::NodeHandle& node, double deadline_s)
      : node_(node), deadline_s_(deadline_s) {
    assignments_ =
        node_.advertise<kg_msgs::Assignments>(kAssignmentsTopic, 1, kLatched);
    // Latched: a selector that was just started is heard by all.
    requests_ = node_.advertise<kg_msgs::RoundRequest>(
        kRoundRequestsTopic, 64,
        [this](const ros::SingleSubscriberPublisher& subscriber) {
          HandleConnection(subscriber.getSubscriberName());
        },
        [this](const ros::SingleSubscriberPublisher& subscriber) {
          HandleDisconnection(subscriber.getSubscriberName());
        },
        ros::VoidConstPtr(), kLatched);
    rejections_ =
        node_.advertise<kg_msgs::Rejections>(kRejectionsTopic, 64, kLatched);
    subscribers_ = {
        node_.subscribe(kWorldTopic, 1, &SelectorNode::HandleWorld, this),
        node_.subscribe(kCoordinationTopic, 1,
                        &SelectorNode::HandleCoordination, this),
        node_.subscribe(kCandidatesTopic, 1000, &SelectorNode::HandleCandidates,
                        this)};
    watch_ = node_.createWallTimer(
        ros::WallDuration(0.25),
        [this](const ros::WallTimerEvent&) { WatchTheDeadline(); });
  }

 private:
  // Run numbers continue above those of a killed predecessor.
  void HandleWorld(const kg_msgs::World& message) {
    Answer([&] { return selector_.KnowRun(message.plan_run); });
  }

  void HandleCoordination(const kg_msgs::CoordinationRules& message) {
    Answer([&] { return selector_.Take(ToTask(message)); });
  }

  void HandleCandidates(const kg_msgs::Candidates& message) {
    Answer([&] { return selector_.Take(FromMessage(message)); });
  }

  void HandleConnection(const std::string& node) {
    std::string agent;
    if (ros::param::get(node + "/agent", agent)) planners_[node] = agent;
  }

  void HandleDisconnection(const std::string& node) {
    const auto planner = planners_.find(node);
    if (planner == planners_.end()) return;  // Not a planner.
    const std::string agent = planner->second;
    planners_.erase(planner);
    const std::vector<std::string> waiting = selector_.WaitingFor();
    const bool is_late =
        std::find(waiting.begin(), waiting.end(), agent) != waiting.end();
    Answer([&] { return selector_.CountDeath(agent); });
    const int deaths = selector_.Deaths(agent);
    // Otherwise idle: the end of the launch, or a restart by hand.
    if (!is_late && deaths != kg_engine::TeamSelector::kMaxDeaths) return;
    ROS_WARN_STREAM("[select] planner for "
                    << agent << " (" << node << ") died, " << deaths << " of "
                    << kg_engine::TeamSelector::kMaxDeaths << " times"
                    << (deaths < kg_engine::TeamSelector::kMaxDeaths
                            ? ""
                            : ": planned without it until it answers")
                    << "; last input: " << selector_.LastInput()
                    << "; exit code in " << ros::file_log::getLogDirectory()
                    << "/roslaunch-*.log");
  }

  void WatchTheDeadline() {
    if (selector_.WaitingFor().empty()) return;
    const double waited_s =
        ros::WallTime::now().toSec() - selector_.waiting_since_s();
    if (waited_s < deadline_s_) return;
    ROS_WARN("[select] %s is late by more than %.1f s: continuing without it",
             selector_.WaitingFor().front().c_str(), deadline_s_);
    Answer([this] { return selector_.GiveUpWaiting(); });
  }

  void Answer(const std::function<kg_engine::SelectorAnswer()>& step) {
    try {
      const kg_engine::SelectorAnswer answer = step();
      if (answer.request) requests_.publish(ToMessage(*answer.request));
      if (answer.end) rejections_.publish(ToMessage(*answer.end));
      if (answer.plan) assignments_.publish(ToMessage(*answer.plan));
    } catch (const kg_base::InputError& error) {
      ROS_ERROR_STREAM("[select] " << error.what());
    }
  }

  ros::NodeHandle node_;
  double deadline_s_;
  kg_engine::TeamSelector selector_;
  std::map<std::string, std::string> planners_;  // Agent, by node.
  ros::Publisher assignments_;
  ros::Publisher requests_;
  ros::Publisher rejections_;
  std::vector<ros::Subscriber> subscribers_;
  ros::WallTimer watch_;
};

}  // namespace

int RunSelectorNode(int argc, char** argv) {
  return RunNode(argc, argv, "selector", [](const ros::NodeHandle& own) {
    ParameterReader read(own);
    const double deadline_s = read.Number("deadline_s", {0.1, 3600.0}, 20.0);
    read.RefuseTheRest();
    const SelectorNode node(ros::NodeHandle(), deadline_s);
    ros::spin();
  });
}

}  // namespace kg_ros
