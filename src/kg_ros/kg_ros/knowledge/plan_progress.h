// How the plan of the current cycle is coming along: what has arrived of it,
// whether it is complete, and what the world is told about it.

#ifndef KG_ROS_KNOWLEDGE_PLAN_PROGRESS_H_
#define KG_ROS_KNOWLEDGE_PLAN_PROGRESS_H_

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "kg_msgs/Assignments.h"
#include "kg_msgs/NavGraph.h"
#include "kg_msgs/Rejections.h"

namespace kg_ros {

class PlanProgress {
 public:
  using Key = std::pair<std::string, int>;  // Agent's ex:id, window.

  // A new cycle: answers to older ones are dropped and counted from now on.
  void Begin(std::uint64_t cycle);

  // False if the message answers for another cycle.
  bool Take(const kg_msgs::Assignments& message);
  bool Take(const kg_msgs::Rejections& message);
  bool Take(const kg_msgs::NavGraph& message);

  // The plan, once, when assignments and the end of the same run's rejections
  // are both here.
  std::optional<kg_msgs::Assignments> TakeFinishedPlan();
  const std::vector<kg_msgs::Rejection>& rejections() const {
    return rejections_.rejections;
  }
  // What agents were asked to plan around: of each pair of agents the last.
  std::vector<kg_msgs::Cooling> cooling() const;
  // At which they were asked to plan, in the last round; as they were told.
  const std::vector<kg_msgs::Price>& prices() const { return prices_; }

  // Graphs of this cycle, by agent and window.
  const std::map<Key, kg_msgs::NavGraph>& nav_graphs() const {
    return nav_graphs_;
  }
  // The next graph that has not been handed out yet.
  const kg_msgs::NavGraph* NextUnrecorded();
  std::uint64_t dropped() const { return dropped_; }

 private:
  template <typename Message>
  bool IsCurrent(const Message& message);

  std::uint64_t cycle_ = 0;
  std::uint64_t dropped_ = 0;
  std::optional<kg_msgs::Assignments> assignments_;
  kg_msgs::Rejections rejections_;
  std::uint64_t asking_run_ = 0;
  // By who is cooled, and by whom.
  std::map<std::pair<std::string, std::string>, kg_msgs::Cooling> cooling_;
  std::uint32_t priced_round_ = 0;
  std::vector<kg_msgs::Price> prices_;
  std::map<Key, kg_msgs::NavGraph> nav_graphs_;
  std::vector<Key> unrecorded_;
};

}  // namespace kg_ros

#endif  // KG_ROS_KNOWLEDGE_PLAN_PROGRESS_H_
