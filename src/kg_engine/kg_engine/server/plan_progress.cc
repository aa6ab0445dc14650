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
  cooling_.clear();
  prices_.clear();
  priced_round_ = 0;
  graphs_.clear();
  unrecorded_.clear();
}

template <typename Value>
bool PlanProgress::IsCurrent(const Value& value) {
  if (value.cycle == cycle_) return true;
  ++dropped_;
  return false;
}

// A selector that began anew asks under another run: what an earlier one had
// asked no longer counts.
void PlanProgress::NoteRun(const std::uint64_t run) {
  if (run != asking_run_) {
    cooling_.clear();
    prices_.clear();
    priced_round_ = 0;
  }
  asking_run_ = run;
}

bool PlanProgress::Take(const CommittedPlan& plan) {
  if (!IsCurrent(plan)) return false;
  plan_ = plan;
  return true;
}

bool PlanProgress::Take(const RoundRequest& request) {
  if (!IsCurrent(request)) return false;
  NoteRun(request.run);
  if (request.round > priced_round_) {
    priced_round_ = request.round;
    prices_ = request.prices;
  }
  for (const CoolingConstraint& one : request.cooling) {
    cooling_[{one.agent, one.by_agent}] = one;
  }
  return true;
}

bool PlanProgress::Take(const RunEnd& end) {
  if (!IsCurrent(end)) return false;
  NoteRun(end.run);
  end_ = end;
  return true;
}

std::vector<CoolingConstraint> PlanProgress::cooling() const {
  std::vector<CoolingConstraint> all;
  for (const auto& [pair, one] : cooling_) all.push_back(one);
  return all;
}

bool PlanProgress::Take(const AgentGraph& graph) {
  if (!IsCurrent(graph)) return false;
  const Key key{graph.agent, graph.window()};
  graphs_[key] = graph;
  unrecorded_.push_back(key);
  return true;
}

std::optional<CommittedPlan> PlanProgress::TakeFinishedPlan() {
  if (!plan_ || end_.run != plan_->run) return std::nullopt;
  std::optional<CommittedPlan> plan;
  plan.swap(plan_);
  return plan;
}

PlanRecord PlanProgress::MakeRecord(const CommittedPlan& plan) const {
  PlanRecord record;
  record.plan = plan;
  record.rejections = rejections();
  record.cooling = cooling();
  record.prices = prices();
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
