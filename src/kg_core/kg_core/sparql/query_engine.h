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

#include <string_view>

#include "kg_core/rdf/graph_view.h"
#include "kg_core/sparql/limits.h"
#include "kg_core/sparql/query_dataset.h"
#include "kg_core/sparql/query_result.h"

namespace kg_core {

// Throws InputError with "line:column: what was expected", or with the limit
// (LimitError) that was hit.
QueryResult RunQuery(const GraphView& view, std::string_view query_text,
                     const Dataset& dataset, const QueryLimits& limits);

}  // namespace kg_core

#endif  // KG_CORE_SPARQL_QUERY_ENGINE_H_
