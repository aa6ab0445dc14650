// SPARQL 1.1 queries over a GraphView: SELECT, ASK, CONSTRUCT and DESCRIBE.
// https://www.w3.org/TR/sparql11-query/
//
//   const QueryResult result =
//       RunQuery(*store.Read(), "SELECT ?a { ?a a ex:Agent }",
//                DefaultDataset(std::nullopt), {});
//
// Queries are safe to run: they change nothing, read nothing but the store, and
// end within their limits. For updates see update_engine.h.

#ifndef KG_CORE_SPARQL_QUERY_ENGINE_H_
#define KG_CORE_SPARQL_QUERY_ENGINE_H_

#include <string_view>

#include "kg_core/rdf/graph_view.h"
#include "kg_core/sparql/limits.h"
#include "kg_core/sparql/query_dataset.h"
#include "kg_core/sparql/query_result.h"

namespace kg_core {

// Throws InputError "line:column: what was expected", or LimitError naming the
// exceeded limit.
QueryResult RunQuery(const GraphView& view, std::string_view query_text,
                     const Dataset& dataset, const QueryLimits& limits);

}  // namespace kg_core

#endif  // KG_CORE_SPARQL_QUERY_ENGINE_H_
