// The plans of a what-if as facts of its fork, for the queries of what_if.h.

#ifndef KG_ENGINE_WHAT_IF_WHAT_IF_FACTS_H_
#define KG_ENGINE_WHAT_IF_WHAT_IF_FACTS_H_

#include <cstdint>
#include <string>
#include <vector>

#include "kg_core/rdf/store.h"
#include "kg_engine/state/executed_stops.h"
#include "kg_engine/what_if/edge_prices.h"

namespace kg_engine {

struct HypotheticalRun {
  std::uint64_t number = 0;
  std::string graph;  // Graph name: ex:graph/plan/<graph>.
  std::vector<ExecutedVisit> executed;
};

// Records the run, its assignments, rejections and waypoint graphs.
void RecordCompiledPlan(const CompiledPlan& world, const HypotheticalRun& run,
                        kg_core::Transaction* transaction);

// Records the cost of each edge of `now` as an ex:EdgeCost in the plan graph of
// that name.
void RecordPrices(const kg_selector::PlannedMission& now,
                  const EdgePrices& prices, const std::string& graph,
                  kg_core::Transaction* transaction);

}  // namespace kg_engine

#endif  // KG_ENGINE_WHAT_IF_WHAT_IF_FACTS_H_
