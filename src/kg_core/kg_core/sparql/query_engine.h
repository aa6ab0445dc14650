// SPARQL 1.1 queries over a GraphView: SELECT, ASK, CONSTRUCT and DESCRIBE.
// https://www.w3.org/TR/sparql11-query/
//
//   const QueryResult result =
//       RunQuery(*store.Read(), "SELECT ?a { ?a a ex:Agent }",
//                DefaultDataset(std::nullopt), {});
//
// A query can do no harm: it changes nothing, reads nothing but the store, and
// ends within its limits. Updates have an entry of their own, update_engine.h.

#ifndef KG_CORE_SPARQL_QUERY_ENGINE_H_
#define KG_CORE_SPARQL_QUERY_ENGINE_H_

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "kg_core/rdf/graph_view.h"
#include "kg_core/rdf/term.h"

namespace kg_core {

struct QueryLimits {
  double seconds = 2.0;
  std::size_t rows = 1000000;     // Or triples.
  std::size_t bytes = 64u << 20;  // Of the result's terms.
  std::size_t text_bytes = 64u << 10;
  int nesting = 200;
  // Of what sorting, grouping, joining and paths must remember.
  std::size_t working_bytes = 256u << 20;
};

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
  // Chosen by whoever sends the query: FROM and FROM NAMED do not count then.
  // https://www.w3.org/TR/sparql11-protocol/#dataset
  bool is_binding = false;
};

// Facts, vocabulary, what is inferred, provenance, agent states and the plan
// graph given (its IRI), for there is history only by GRAPH.
Dataset DefaultDataset(const std::optional<std::string>& plan_graph);

struct Triple {
  Term subject;
  Term predicate;
  Term object;
};

struct QueryResult {
  enum class Form { kSelect, kAsk, kConstruct, kDescribe };
  Form form = Form::kSelect;
  std::vector<std::string> variables;
  std::vector<std::vector<std::optional<Term>>> rows;
  bool answer = false;
  std::vector<Triple> triples;  // Of CONSTRUCT and DESCRIBE, each once.
};

// Throws InputError with "line:column: what was expected", or with the limit
// (LimitError) that was hit.
QueryResult RunQuery(const GraphView& view, std::string_view query_text,
                     const Dataset& dataset, const QueryLimits& limits);

}  // namespace kg_core

#endif  // KG_CORE_SPARQL_QUERY_ENGINE_H_
