#include "kg_core/watch/watch_facts.h"

#include <map>
#include <string>

#include "kg_core/facts/terms.h"
#include "kg_core/rdf/namespaces.h"

namespace kg_core {

std::vector<WatchDefinition> ReadWatches(const GraphView& view) {
  std::map<std::string, std::string> queries;  // Query text by watch id.
  for (const Term& node : Subjects(view, kWatchGraph, RdfType(), Ex("Watch"))) {
    const auto id = FirstObject(view, kWatchGraph, node, Ex("id"));
    const auto query = FirstObject(view, kWatchGraph, node, Ex("query"));
    if (id && query) queries[id->text] = query->text;
  }
  std::vector<WatchDefinition> watches;
  for (const auto& [id, query] : queries) watches.push_back({id, query});
  return watches;
}

void StageWatches(const std::vector<WatchDefinition>& watches,
                  Transaction& transaction) {
  const Term graph = Iri(kWatchGraph);
  transaction.RemoveMatching(nullptr, nullptr, nullptr, graph);
  for (const WatchDefinition& watch : watches) {
    const Term node = Ex("watch/" + watch.id);
    transaction.Add({node, RdfType(), Ex("Watch"), graph});
    transaction.Add({node, Ex("id"), Literal(watch.id), graph});
    transaction.Add({node, Ex("query"), Literal(watch.query), graph});
  }
}

}  // namespace kg_core
