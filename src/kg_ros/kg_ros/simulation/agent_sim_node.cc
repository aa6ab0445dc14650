#include "kg_ros/simulation/agent_sim_node.h"

#include <map>

#include "kg_base/common/input_error.h"
#include "kg_base/common/units.h"
#include "kg_engine/simulation/agent_simulator.h"
#include "kg_msgs/AgentState.h"
#include "kg_msgs/Assignments.h"
#include "kg_msgs/SeamRules.h"
#include "kg_msgs/World.h"
#include "kg_ros/base/names.h"
#include "kg_ros/base/parameter_reader.h"
#include "kg_ros/base/run_node.h"
#include "kg_ros/conversion/agent_conversion.h"
#include "kg_ros/conversion/plan_conversion.h"
#include "ros/ros.h"

namespace kg_ros {
namespace {

constexpr double kTick_s = 0.1;

class AgentSimNode {
 public:
  AgentSimNode(const ros::NodeHandle& node, double hours_per_s)
      : node_(node),
        simulator_(kg_base::HoursToSeconds(hours_per_s)),
        last_tick_(ros::SteadyTime::now()) {
    states_ = node_.advertise<kg_msgs::AgentState>(kAgentStatesTopic, 100);
    world_ = node_.subscribe(kWorldTopic, 1, &AgentSimNode::HandleWorld, this);
    plan_ = node_.subscribe(kAssignmentsTopic, 1,
                            &AgentSimNode::HandleAssignments, this);
    timer_ =
        node_.createWallTimer(ros::WallDuration(kTick_s),
                              [this](const ros::WallTimerEvent&) { Tick(); });
  }

 private:
  void HandleWorld(const kg_msgs::World& message) {
    simulator_.Take(FromMessage(message));
    for (const std::string& agent : simulator_.agents()) {
      if (rules_.count(agent) > 0) continue;
      rules_[agent] = node_.subscribe(AgentTopic(agent, kSeamRules), 1,
                                      &AgentSimNode::HandleRules, this);
    }
  }

  void HandleAssignments(const kg_msgs::Assignments& message) {
    try {
      simulator_.Take(FromMessage(message));
    } catch (const kg_base::InputError& error) {
      ROS_ERROR_STREAM("[sim] plan not followed: " << error.what());
    }
  }

  void HandleRules(const kg_msgs::SeamRules& message) {
    simulator_.TakeEnergy(message.agent, message.energy_budget_j);
  }

  void Tick() {
    const ros::SteadyTime now = ros::SteadyTime::now();
    const double real_s = (now - last_tick_).toSec();
    last_tick_ = now;
    for (const auto& state : simulator_.Advance(real_s)) {
      states_.publish(ToMessage(state));
    }
  }

  ros::NodeHandle node_;
  kg_engine::AgentSimulator simulator_;
  ros::SteadyTime last_tick_;
  ros::Publisher states_;
  ros::Subscriber world_;
  ros::Subscriber plan_;
  std::map<std::string, ros::Subscriber> rules_;
  ros::WallTimer timer_;
};

}  // namespace

int RunAgentSimNode(int argc, char** argv) {
  return RunNode(argc, argv, "agent_sim", [](const ros::NodeHandle& own) {
    ParameterReader read(own);
    const double hours_per_s = read.Number("rate", {0.0, 1000.0}, 2.0);
    read.RefuseTheRest();
    const AgentSimNode node(ros::NodeHandle(), hours_per_s);
    ros::spin();
  });
}

}  // namespace kg_ros
