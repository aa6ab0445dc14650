#include "kg_ros/knowledge/plan_status.h"

namespace kg_ros {

using kg_msgs::World;

void PlanStatus::Set(std::uint8_t status, const std::string& note) {
  status_ = status;
  note_ = note;
  is_stale_by_missing_ = false;
}

void PlanStatus::Expire() {
  Set(status_ == World::PLAN_NONE ? World::PLAN_NONE : World::PLAN_STALE, "");
}

void PlanStatus::Fail(const std::string& why) { Set(World::PLAN_FAILED, why); }

void PlanStatus::Commit(const std::string& unassigned) {
  Set(unassigned.empty() ? World::PLAN_OK : World::PLAN_FAILED, unassigned);
}

bool PlanStatus::SetMissing(const std::string& missing) {
  if (is_ok() && !missing.empty()) {
    Set(World::PLAN_STALE, missing);
    is_stale_by_missing_ = true;
    return true;
  }
  if (is_stale_by_missing_ && missing.empty()) {
    Set(World::PLAN_OK, "");
    return true;
  }
  return false;
}

}  // namespace kg_ros
