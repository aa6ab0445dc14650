#include "kg_ros/knowledge/plan_progress.h"

namespace kg_ros {

void PlanProgress::Begin(const std::uint64_t cycle) {
  cycle_ = cycle;
  assignments_.reset();
  rejections_ = {};
  cooling_.clear();
  prices_.clear();
  priced_round_ = 0;
  nav_graphs_.clear();
  unrecorded_.clear();
}

template <typename Message>
bool PlanProgress::IsCurrent(const Message& message) {
  if (message.cycle == cycle_) return true;
  ++dropped_;
  return false;
}

bool PlanProgress::Take(const kg_msgs::Assignments& message) {
  if (!IsCurrent(message)) return false;
  assignments_ = message;
  return true;
}

bool PlanProgress::Take(const kg_msgs::Rejections& message) {
  if (!IsCurrent(message)) return false;
  const bool run_has_ended = message.round == 0;
  if (run_has_ended) rejections_ = message;
  if (message.plan_run != asking_run_) {
    cooling_.clear();
    prices_.clear();
    priced_round_ = 0;
  }
  asking_run_ = message.plan_run;
  if (message.round > priced_round_) {
    priced_round_ = message.round;
    prices_ = message.prices;
  }
  for (const kg_msgs::Cooling& one : message.cooling) {
    cooling_[{one.agent, one.by_agent}] = one;
  }
  return true;
}

std::vector<kg_msgs::Cooling> PlanProgress::cooling() const {
  std::vector<kg_msgs::Cooling> all;
  for (const auto& [pair, one] : cooling_) all.push_back(one);
  return all;
}

bool PlanProgress::Take(const kg_msgs::NavGraph& message) {
  if (!IsCurrent(message)) return false;
  const Key key{message.agent, message.window};
  nav_graphs_[key] = message;
  unrecorded_.push_back(key);
  return true;
}

std::optional<kg_msgs::Assignments> PlanProgress::TakeFinishedPlan() {
  if (!assignments_ || rejections_.plan_run != assignments_->plan_run) {
    return std::nullopt;
  }
  std::optional<kg_msgs::Assignments> plan;
  plan.swap(assignments_);
  return plan;
}

const kg_msgs::NavGraph* PlanProgress::NextUnrecorded() {
  if (unrecorded_.empty()) return nullptr;
  const Key key = unrecorded_.back();
  unrecorded_.pop_back();
  return &nav_graphs_.at(key);
}

}  // namespace kg_ros
