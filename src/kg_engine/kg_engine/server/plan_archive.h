// Inputs of explanations for one planning cycle; thread-safe.
//
// Filled incrementally: the compilation when a cycle begins, waypoint graphs as
// they arrive, the plan when it is committed. An answer is computed from an
// immutable snapshot of one world version; the graphs of a plan are converted
// on first use.

#ifndef KG_ENGINE_SERVER_PLAN_ARCHIVE_H_
#define KG_ENGINE_SERVER_PLAN_ARCHIVE_H_

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "kg_compiler/compile/mission_compiler.h"
#include "kg_core/rdf/graph_view.h"
#include "kg_engine/facts/plan_facts.h"
#include "kg_engine/planning/agent_graph.h"
#include "kg_selector/explain/planned_world.h"

namespace kg_engine {

class PlanArchive {
 public:
  using World = std::shared_ptr<const kg_selector::PlannedWorld>;

  // `view` holds the facts that `compilation` was made from.
  void Begin(std::uint64_t cycle,
             std::shared_ptr<const kg_compiler::Compilation> compilation,
             std::shared_ptr<const kg_core::GraphView> view);
  // Ignored unless it belongs to the current cycle.
  void Take(const AgentGraph& graph);
  // The plan of the current cycle; `view` also holds its facts.
  void Commit(const PlanRecord& record,
              std::shared_ptr<const kg_core::GraphView> view);

  // The newest compilation, possibly without plan; null = none.
  World Newest() const;
  // The last committed plan; null = none.
  World Planned() const;

 private:
  using Graphs = std::map<std::pair<std::string, int>,
                          std::shared_ptr<const kg_compiler::NavGraph>>;
  struct Cycle {
    std::uint64_t number = 0;
    std::shared_ptr<const kg_compiler::Compilation> compilation;
    std::shared_ptr<const kg_core::GraphView> view;
    Graphs graphs;  // By ex:id and window.
    std::shared_ptr<const PlanRecord> record;
  };
  static World Convert(const Cycle& cycle);

  mutable std::mutex mutex_;
  Cycle newest_;
  Cycle planned_;
  // Cached conversion of planned_; null = not yet converted.
  mutable World converted_;
};

}  // namespace kg_engine

#endif  // KG_ENGINE_SERVER_PLAN_ARCHIVE_H_
