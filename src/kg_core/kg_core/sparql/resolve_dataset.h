// The graphs that a query or an update reads, by id.
// https://www.w3.org/TR/sparql11-query/#rdfDataset

#ifndef KG_CORE_SPARQL_RESOLVE_DATASET_H_
#define KG_CORE_SPARQL_RESOLVE_DATASET_H_

#include <string>

#include "kg_core/sparql/evaluator.h"
#include "kg_core/sparql/query.h"
#include "kg_core/sparql/query_dataset.h"
#include "kg_core/sparql/term_table.h"

namespace kg_core::sparql {

// Has the graph a quad, or is it one of those that every store has?
bool HasGraph(const GraphView& view, const std::string& iri);

// FROM names graphs of the store only: a typo must not look like "no rows".
// Throws InputError.
void CheckDataset(const GraphView& view, const Query& query);

// FROM and FROM NAMED of `query`, else `dataset`.
DatasetIds Resolve(const Query& query, const Dataset& dataset,
                   TermTable* terms);

}  // namespace kg_core::sparql

#endif  // KG_CORE_SPARQL_RESOLVE_DATASET_H_
