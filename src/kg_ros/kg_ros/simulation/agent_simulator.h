// Moves agents along their assigned tracks in mission time, and counts down
// their energy: a stand-in for vehicles that follow their plan.
//
// Mission time goes on while the plan is up to date (or has failed: then the
// last one is followed) and stands still while a new one is being made, so that
// planning takes no mission time however fast the mission is played. It stops
// at every window's end until the world has entered the next. A plan that
// begins a moment ago (it was made while agents went on) is followed from its
// begin.

#ifndef KG_ROS_SIMULATION_AGENT_SIMULATOR_H_
#define KG_ROS_SIMULATION_AGENT_SIMULATOR_H_

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "kg_compiler/traversal/traversal.h"
#include "kg_msgs/AgentState.h"
#include "kg_msgs/Assignments.h"
#include "kg_msgs/SeamRules.h"
#include "kg_msgs/World.h"

namespace kg_ros {

class AgentSimulator {
 public:
  // `rate`: mission seconds per real second.
  explicit AgentSimulator(double rate) : rate_(rate) {}

  void Take(const kg_msgs::World& message);
  void Take(const kg_msgs::Assignments& message);
  void Take(const kg_msgs::SeamRules& message);

  // Ids of the agents of the world.
  std::vector<std::string> agents() const;

  // `real_s` seconds later: where everybody is. Empty while there is no plan,
  // or the mission has ended.
  std::vector<kg_msgs::AgentState> Advance(double real_s);

 private:
  struct Agent {
    std::vector<kg_compiler::TimedPoint> track;
    std::vector<kg_msgs::Visit> visits;
    double energy_j = 0.0;  // Left when the track begins.
    bool has_energy = false;
  };

  kg_msgs::AgentState StateOf(const std::string& id, const Agent& agent) const;
  double EnergyUsed_j(const Agent& agent) const;
  bool MayGoOn() const;
  double Limit_s() const;

  double rate_;
  double time_s_ = 0.0;  // Mission time, unix seconds.
  kg_msgs::World world_;
  std::uint64_t plan_run_ = 0;  // Of the tracks that are followed.
  std::map<std::string, Agent> agents_;
};

}  // namespace kg_ros

#endif  // KG_ROS_SIMULATION_AGENT_SIMULATOR_H_
