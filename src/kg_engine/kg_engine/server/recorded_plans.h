// The plans among the facts of a store: recorded with their provenance, marked
// stale or superseded, and deleted when old. Stages only; the owner of the
// store commits.

#ifndef KG_ENGINE_SERVER_RECORDED_PLANS_H_
#define KG_ENGINE_SERVER_RECORDED_PLANS_H_

#include <cstdint>
#include <string>

#include "kg_compiler/compile/mission_compiler.h"
#include "kg_core/rdf/graph_view.h"
#include "kg_core/rdf/store.h"
#include "kg_engine/facts/plan_facts.h"
#include "kg_engine/planning/agent_graph.h"
#include "kg_engine/state/start_state.h"

namespace kg_engine {

// The planning cycle that a plan belongs to.
struct RecordedCycle {
  const kg_compiler::Compilation& compilation;
  std::uint64_t number = 0;
  double compiled_s = 0.0;  // Earliest begin of planning [Unix s].
};

class RecordedPlans {
 public:
  // Number of the current plan's run; 0 = none.
  std::uint64_t run() const { return run_; }
  void SetRun(std::uint64_t run) { run_ = run; }

  // Stages the plan's facts and the provenance of its graphs; the previous plan
  // becomes superseded, and an old one is deleted. Call SetRun() once durable.
  void StagePlan(const PlanRecord& record, const RecordedCycle& cycle,
                 kg_core::Transaction* transaction) const;

  // Stages a waypoint graph of the current plan, which may arrive after it.
  // False if the agent is not in the cycle, or if the graph of the previous
  // window (`previous_hash`, empty if unknown) is missing.
  bool StageGraph(const AgentGraph& graph, const std::string& previous_hash,
                  const RecordedCycle& cycle,
                  kg_core::Transaction* transaction) const;

  // Marks the current plan as stale.
  void StageStale(kg_core::Transaction* transaction) const;
  // Marks all planned stops of the current plan as executed.
  void StageEnd(const kg_core::GraphView& view,
                kg_core::Transaction* transaction) const;

 private:
  void StageUse(const AgentGraph& graph,
                kg_core::Transaction* transaction) const;

  std::uint64_t run_ = 0;
};

// End places of a plan, by ex:id and window.
PlannedPlaces ToPlannedPlaces(const kg_selector::CommittedPlan& plan);

}  // namespace kg_engine

#endif  // KG_ENGINE_SERVER_RECORDED_PLANS_H_
