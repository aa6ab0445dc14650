// Resolves the dataset of a query or update to graph ids.
// https://www.w3.org/TR/sparql11-query/#rdfDataset

#ifndef KG_CORE_SPARQL_RESOLVE_DATASET_H_
#define KG_CORE_SPARQL_RESOLVE_DATASET_H_

#include <string>

#include "kg_core/sparql/evaluator.h"
#include "kg_core/sparql/query.h"
#include "kg_core/sparql/query_dataset.h"
#include "kg_core/sparql/term_table.h"

namespace kg_core::sparql {

// True if the graph has a quad or is one of the graphs that every store has.
bool HasGraph(const GraphView& view, const std::string& iri);

// Throws InputError if FROM names a graph that is not in the store: a typo must
// not look like an empty result.
void CheckDataset(const GraphView& view, const Query& query);

// FROM and FROM NAMED of `query` if given, else `dataset`.
DatasetIds Resolve(const Query& query, const Dataset& dataset,
                   TermTable* terms);

}  // namespace kg_core::sparql

#endif  // KG_CORE_SPARQL_RESOLVE_DATASET_H_
