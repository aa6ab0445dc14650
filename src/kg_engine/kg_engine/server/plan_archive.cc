#include "kg_engine/server/plan_archive.h"

#include "kg_engine/terms/plan_names.h"
#include "kg_selector/team/plan_mission.h"

namespace kg_engine {
namespace {

using kg_selector::PlannedWorld;
using kg_selector::TeamMember;

// Member with the graphs of one agent received without a gap.
template <typename Graphs>
TeamMember ToMember(const kg_compiler::SeamRules& rules, const Graphs& graphs) {
  TeamMember member;
  member.rules = rules;
  for (const kg_compiler::WindowRules& window : rules.windows) {
    const auto graph = graphs.find({rules.agent_id, window.window});
    if (graph == graphs.end()) break;
    member.graphs.push_back(graph->second);
  }
  return member;
}

// Archived form of a rejected pathlet: its score, without visits and track.
kg_selector::RejectedPath ToArchived(
    const kg_selector::RecordedRejection& rejected) {
  kg_selector::RejectedPath rejection = rejected.rejection;
  kg_selector::Pathlet told;
  told.agent = rejected.agent_iri;
  told.rank = rejection.pathlet.rank;
  told.reward = rejection.pathlet.score();
  rejection.pathlet = told;
  return rejection;
}

void AddPlan(const PlanRecord& record, PlannedWorld* world) {
  const kg_selector::CommittedPlan& plan = record.plan;
  world->has_plan = true;
  world->run_iri = PlanRunNode(plan.run).text;
  world->plan_graph = PlanGraph(plan.run).text;
  for (const kg_selector::PathAssignment& assignment : plan.assignments) {
    world->plan.committed.push_back(assignment.pathlet);
    world->plan.committed.back().agent = assignment.agent_iri;
  }
  for (const kg_selector::RecordedRejection& rejected : record.rejections) {
    world->plan.rejections.push_back(ToArchived(rejected));
  }
  world->plan.unassigned = plan.unassigned;
  for (const ExecutedVisit& past : record.executed) {
    for (const std::string& event : past.visit.events) {
      world->past_visits[event].push_back(past.agent_iri);
    }
  }
}

}  // namespace

void PlanArchive::Begin(
    const std::uint64_t cycle,
    std::shared_ptr<const kg_compiler::Compilation> compilation,
    std::shared_ptr<const kg_core::GraphView> view) {
  const std::lock_guard<std::mutex> lock(mutex_);
  newest_ = {cycle, std::move(compilation), std::move(view), {}, nullptr};
}

void PlanArchive::Take(const AgentGraph& graph) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (graph.cycle != newest_.number) return;
  const std::pair<std::string, int> key{graph.agent, graph.window()};
  newest_.graphs[key] = graph.graph;
  if (planned_.number != newest_.number) return;
  planned_.graphs[key] = graph.graph;  // The graph arrived after the plan.
  converted_.reset();
}

void PlanArchive::Commit(const PlanRecord& record,
                         std::shared_ptr<const kg_core::GraphView> view) {
  auto kept = std::make_shared<const PlanRecord>(record);
  const std::lock_guard<std::mutex> lock(mutex_);
  planned_ = newest_;
  planned_.record = std::move(kept);
  planned_.view = std::move(view);
  converted_.reset();
}

PlanArchive::World PlanArchive::Convert(const Cycle& cycle) {
  auto world = std::make_shared<PlannedWorld>();
  world->view = cycle.view;
  world->compilation = cycle.compilation;
  world->rules = kg_selector::ToTeamRules(*cycle.compilation);
  for (const kg_compiler::SeamRules& rules : cycle.compilation->rules) {
    world->members.push_back(ToMember(rules, cycle.graphs));
  }
  if (cycle.record) AddPlan(*cycle.record, world.get());
  kg_selector::NameAgentsByIri(world.get());
  return world;
}

PlanArchive::World PlanArchive::Newest() const {
  Cycle cycle;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    cycle = newest_;
  }
  cycle.graphs.clear();
  return cycle.compilation ? Convert(cycle) : nullptr;
}

PlanArchive::World PlanArchive::Planned() const {
  Cycle cycle;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (converted_) return converted_;
    cycle = planned_;
  }
  if (!cycle.record) return nullptr;
  World world = Convert(cycle);  // Outside the lock, because it is slow.
  const std::lock_guard<std::mutex> lock(mutex_);
  const bool is_still_it = cycle.record == planned_.record &&
                           cycle.graphs.size() == planned_.graphs.size();
  if (is_still_it) converted_ = world;
  return world;
}

}  // namespace kg_engine
