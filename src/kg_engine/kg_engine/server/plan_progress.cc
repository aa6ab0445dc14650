#include "kg_engine/server/plan_progress.h"

namespace kg_engine {

using kg_selector::CommittedPlan;
using kg_selector::CoolingConstraint;
using kg_selector::RoundRequest;
using kg_selector::RunEnd;

void PlanProgress::Begin(const std::uint64_t cycle) {
  cycle_ = cycle;
  plan_.reset();
  end_ = {};
  requests_.clear();
  last_asked_run_ = 0;
  graphs_.clear();
  unrecorded_.clear();
}

template <typename Value>
bool PlanProgress::IsCurrent(const Value& value) {
  if (value.cycle == cycle_) return true;
  ++dropped_;
  return false;
}

bool PlanProgress::Take(const CommittedPlan& plan) {
  if (!IsCurrent(plan)) return false;
  plan_ = plan;
  return true;
}

bool PlanProgress::Take(const RoundRequest& request) {
  if (!IsCurrent(request)) return false;
  last_asked_run_ = request.run;
  RunRequests& run = requests_[request.run];
  if (request.round > run.last_round) {
    run.last_round = request.round;
    run.prices = request.prices;
  }
  for (const CoolingConstraint& one : request.cooling) {
    run.cooling[{one.agent, one.by_agent}] = one;
  }
  return true;
}

bool PlanProgress::Take(const RunEnd& end) {
  if (!IsCurrent(end)) return false;
  end_ = end;
  return true;
}

PlanProgress::RunRequests PlanProgress::RequestsOf(
    const std::uint64_t run) const {
  const auto known = requests_.find(run);
  return known == requests_.end() ? RunRequests() : known->second;
}

bool PlanProgress::Take(const AgentGraph& graph) {
  if (!IsCurrent(graph)) return false;
  const Key key{graph.agent, graph.window()};
  graphs_[key] = graph;
  unrecorded_.push_back(key);
  return true;
}

bool PlanProgress::IsFinished() const {
  if (!plan_ || end_.run != plan_->run) return false;
  // The plan and its end may overtake requests, which arrive in their own
  // order: with that of the last round, or of a later run, all are here.
  return last_asked_run_ > plan_->run ||
         static_cast<int>(RequestsOf(plan_->run).last_round) >= plan_->rounds;
}

std::optional<CommittedPlan> PlanProgress::TakeFinishedPlan() {
  if (!IsFinished()) return std::nullopt;
  std::optional<CommittedPlan> plan;
  plan.swap(plan_);
  return plan;
}

PlanRecord PlanProgress::MakeRecord(const CommittedPlan& plan) const {
  PlanRecord record;
  record.plan = plan;
  record.rejections = rejections();
  // Not those of other runs in this cycle.
  const RunRequests requests = RequestsOf(plan.run);
  for (const auto& [pair, one] : requests.cooling) {
    record.cooling.push_back(one);
  }
  record.prices = requests.prices;
  for (const auto& [key, graph] : graphs_) {
    record.nav_graphs[key] = ToStamp(*graph.graph, graph.made_s);
  }
  return record;
}

std::string PlanProgress::HashBefore(const AgentGraph& graph) const {
  const auto before = graphs_.find({graph.agent, graph.window() - 1});
  return before == graphs_.end() ? "" : before->second.graph->hash;
}

const AgentGraph* PlanProgress::NextUnrecorded() {
  if (unrecorded_.empty()) return nullptr;
  const Key key = unrecorded_.back();
  unrecorded_.pop_back();
  return &graphs_.at(key);
}

}  // namespace kg_engine
