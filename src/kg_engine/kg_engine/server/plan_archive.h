// What explanations are made from, of one planning cycle; safe to use from
// several threads.
//
// It is handed over as it comes to be: the compilation when a cycle begins,
// waypoint graphs as they arrive, the plan when it is committed. An answer is
// made from an immutable snapshot of that, of one world version; the graphs of
// a plan become one when it is first asked about.

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
  // Ignored unless it is of the cycle that began last.
  void Take(const AgentGraph& graph);
  // The plan of the cycle that began last; `view` holds its facts, too.
  void Commit(const PlanRecord& record,
              std::shared_ptr<const kg_core::GraphView> view);

  // The newest compilation, perhaps without plan; null = there is none.
  World Newest() const;
  // The last committed plan; null = there is none.
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
  mutable World converted_;  // Of planned_; null = to be made.
};

}  // namespace kg_engine

#endif  // KG_ENGINE_SERVER_PLAN_ARCHIVE_H_
