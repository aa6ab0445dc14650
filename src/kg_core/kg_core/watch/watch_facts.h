// Persistence of watches as statements (graph ex:graph/watch), across restarts.

#ifndef KG_CORE_WATCH_WATCH_FACTS_H_
#define KG_CORE_WATCH_WATCH_FACTS_H_

#include <vector>

#include "kg_core/rdf/graph_view.h"
#include "kg_core/rdf/store.h"
#include "kg_core/watch/watch_list.h"

namespace kg_core {

inline constexpr char kWatchGraph[] = "http://example.org/mission/graph/watch";

// The watches in the graph, sorted by id. Invalid ones are skipped.
std::vector<WatchDefinition> ReadWatches(const GraphView& view);

// Replaces all stored watches.
void StageWatches(const std::vector<WatchDefinition>& watches,
                  Transaction& transaction);

}  // namespace kg_core

#endif  // KG_CORE_WATCH_WATCH_FACTS_H_
