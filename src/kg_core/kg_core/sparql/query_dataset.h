// The RDF dataset of a query. https://www.w3.org/TR/sparql11-query/#rdfDataset

#ifndef KG_CORE_SPARQL_QUERY_DATASET_H_
#define KG_CORE_SPARQL_QUERY_DATASET_H_

#include <optional>
#include <string>
#include <vector>

namespace kg_core {

// Graphs are IRIs. FROM and FROM NAMED of a query replace both members.
// https://www.w3.org/TR/sparql11-query/#rdfDataset
struct Dataset {
  // Graphs merged (without duplicates) into the default graph, which patterns
  // outside GRAPH match.
  std::vector<std::string> default_graphs;
  // Graphs that GRAPH can match; nullopt: all graphs of the store.
  std::optional<std::vector<std::string>> named_graphs;
  // The store's name for the graph that is unnamed in SPARQL; not matched by
  // GRAPH ?g if named_graphs is nullopt. "": none.
  std::string unnamed_graph{};
  // True if the client specified the dataset in the request: FROM and FROM
  // NAMED are then ignored. https://www.w3.org/TR/sparql11-protocol/#dataset
  bool is_binding = false;
};

// Facts, vocabulary, inferred facts, provenance, agent states and the given
// plan graph (its IRI) as default graph; older plan graphs are reached by GRAPH
// only.
Dataset DefaultDataset(const std::optional<std::string>& plan_graph);

}  // namespace kg_core

#endif  // KG_CORE_SPARQL_QUERY_DATASET_H_
