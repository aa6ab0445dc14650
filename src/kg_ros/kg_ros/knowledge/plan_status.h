// Whether the published plan accounts for the facts in force, and if not, why.

#ifndef KG_ROS_KNOWLEDGE_PLAN_STATUS_H_
#define KG_ROS_KNOWLEDGE_PLAN_STATUS_H_

#include <kg_msgs/World.h>

#include <cstdint>
#include <string>

namespace kg_ros {

// What World.plan_status and World.plan_note say. A missing node makes a plan
// stale only until the node is back; every other cause, until the next plan.
class PlanStatus {
 public:
  std::uint8_t status() const { return status_; }  // World::PLAN_*.
  const std::string& note() const { return note_; }
  bool is_ok() const { return status_ == kg_msgs::World::PLAN_OK; }

  // Facts or the window have changed, or planning has begun.
  void Expire();
  void Fail(const std::string& why);
  // A plan was committed; `unassigned` says which agents have no path, "" =
  // none.
  void Commit(const std::string& unassigned);
  // `missing`: what is not connected, "" = nothing. Returns whether the status
  // has changed.
  bool SetMissing(const std::string& missing);

 private:
  void Set(std::uint8_t status, const std::string& note);

  std::uint8_t status_ = kg_msgs::World::PLAN_NONE;
  std::string note_;
  bool is_stale_by_missing_ = false;
};

}  // namespace kg_ros

#endif  // KG_ROS_KNOWLEDGE_PLAN_STATUS_H_
