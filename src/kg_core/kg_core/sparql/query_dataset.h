// The graphs that a query sees.
// https://www.w3.org/TR/sparql11-query/#rdfDataset

#ifndef KG_CORE_SPARQL_QUERY_DATASET_H_
#define KG_CORE_SPARQL_QUERY_DATASET_H_

#include <optional>
#include <string>
#include <vector>

namespace kg_core {

// Graphs are IRIs. FROM and FROM NAMED of a query replace both members.
// https://www.w3.org/TR/sparql11-query/#rdfDataset
struct Dataset {
  // Merged, duplicates removed: what patterns outside of GRAPH see.
  std::vector<std::string> default_graphs;
  // What GRAPH sees; nothing: every graph of the store.
  std::optional<std::vector<std::string>> named_graphs;
  // Never seen by GRAPH ?g where named_graphs is nothing: the store's name for
  // what has no name in SPARQL. "": there is none.
  std::string unnamed_graph{};
  // Chosen by the sender of the query: FROM and FROM NAMED have no effect then.
  // https://www.w3.org/TR/sparql11-protocol/#dataset
  bool is_binding = false;
};

// Facts, vocabulary, what is inferred, provenance, agent states and the plan
// graph given (its IRI), for there is history only by GRAPH.
Dataset DefaultDataset(const std::optional<std::string>& plan_graph);

}  // namespace kg_core

#endif  // KG_CORE_SPARQL_QUERY_DATASET_H_
