// SPARQL 1.1 updates within a transaction.
// https://www.w3.org/TR/sparql11-update/
//
//   Transaction change = store.Begin();
//   RunUpdate("DELETE { ?a ex:speed ?v } INSERT { ?a ex:speed 0.3 } "
//             "WHERE { ?a ex:speed ?v }", {}, {}, &change);
//   if (Validate(change.view()).empty()) change.Commit(WorldChange::kYes);
//
// All or nothing: on an error the transaction is rolled back to its state
// before the call. Files and the network are never read: LOAD is an error,
// which SILENT turns into a no-op
// (https://www.w3.org/TR/sparql11-update/#load). Operations run in order, each
// on the result of the previous ones; an operation matches its pattern before
// it changes anything. The store has no empty graphs: CREATE has no effect,
// CLEAR and DROP are equivalent, and COPY, MOVE and ADD from a graph without
// quads are errors, which SILENT turns into no-ops.

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
  // Target of quads outside GRAPH, and the DEFAULT graph of CLEAR, DROP, COPY,
  // MOVE and ADD; WITH replaces it, except for DEFAULT.
  std::string default_graph = kFactsGraph;
  // Dataset that patterns read; WITH replaces its default graphs, USING all of
  // it.
  Dataset read = DefaultDataset(std::nullopt);
  // Graphs that may be changed; nullopt: every graph.
  std::optional<std::vector<std::string>> writable;
};

// The limits on rows and bytes apply to the quads removed and added by each
// operation. Throws InputError like RunQuery.
void RunUpdate(std::string_view text, const UpdateGraphs& graphs,
               const QueryLimits& limits, Transaction* change);

}  // namespace kg_core

#endif  // KG_CORE_SPARQL_UPDATE_ENGINE_H_
