// SPARQL 1.1 updates within a transaction.
// https://www.w3.org/TR/sparql11-update/
//
//   Transaction change = store.Begin();
//   RunUpdate("DELETE { ?a ex:speed ?v } INSERT { ?a ex:speed 0.3 } "
//             "WHERE { ?a ex:speed ?v }", {}, {}, &change);
//   if (Validate(change.view()).empty()) change.Commit(WorldChange::kYes);
//
// All or nothing: on an error the transaction is as it was before. Files and
// the network are never read: LOAD is an error, which SILENT turns into doing
// nothing (https://www.w3.org/TR/sparql11-update/#load). Operations run in
// order, each on what the ones before it left; what one matches it does not see
// change. The store knows no empty graphs: CREATE makes nothing, CLEAR and DROP
// do the same, and COPY, MOVE and ADD from a graph without quads are errors,
// which SILENT turns into doing nothing.

#ifndef KG_CORE_SPARQL_UPDATE_ENGINE_H_
#define KG_CORE_SPARQL_UPDATE_ENGINE_H_

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "kg_core/rdf/namespaces.h"
#include "kg_core/rdf/store.h"
#include "kg_core/sparql/limits.h"
#include "kg_core/sparql/query_dataset.h"

namespace kg_core {

struct UpdateGraphs {
  // What is written outside of GRAPH, and DEFAULT of CLEAR and its kin; WITH
  // replaces it, except for DEFAULT.
  std::string default_graph = kFactsGraph;
  // What patterns see; WITH replaces its default graphs, USING all of it.
  Dataset read = DefaultDataset(std::nullopt);
  // What may be changed; nothing: every graph.
  std::optional<std::vector<std::string>> writable;
};

// Of the limits, rows and bytes bound the quads removed and added by each
// operation. Throws InputError like RunQuery.
void RunUpdate(std::string_view text, const UpdateGraphs& graphs,
               const QueryLimits& limits, Transaction* change);

}  // namespace kg_core

#endif  // KG_CORE_SPARQL_UPDATE_ENGINE_H_
