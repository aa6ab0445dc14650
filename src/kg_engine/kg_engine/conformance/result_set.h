// Expected results: reading from any of their formats, and comparison.

#ifndef KG_ENGINE_CONFORMANCE_RESULT_SET_H_
#define KG_ENGINE_CONFORMANCE_RESULT_SET_H_

#include <string>
#include <vector>

#include "kg_core/rdf/store.h"
#include "kg_core/sparql/query_result.h"

namespace kg_engine::conformance {

struct ExpectedResult {
  kg_core::QueryResult result;
  // Result of CONSTRUCT or DESCRIBE; the file does not distinguish them:
  // kConstruct.
  std::vector<kg_core::Statement> statements;
  bool is_ordered = false;  // rs:index numbers the rows.
};

// Reads the result at `url`: .srx, .srj, .csv, .tsv, or RDF with a rs:ResultSet
// or a graph.
ExpectedResult ReadExpected(const std::string& url);

// Round trip of `got` through the format of `url`, so that writers are tested
// too; RDF has no writer and is returned unchanged.
kg_core::QueryResult ThroughFormat(const kg_core::QueryResult& got,
                                   const std::string& url);

// "" if equal: rows as a bag up to the labels of blank nodes, with numbers by
// value; ordered if the expected result is. `is_lax`: for REDUCED, rows may
// occur less often. https://www.w3.org/2001/sw/DataAccess/tests/README
std::string Difference(const kg_core::QueryResult& got,
                       const ExpectedResult& want, bool is_lax);
// "" if the datasets are isomorphic.
std::string Difference(const std::vector<kg_core::Statement>& got,
                       const std::vector<kg_core::Statement>& want);

}  // namespace kg_engine::conformance

#endif  // KG_ENGINE_CONFORMANCE_RESULT_SET_H_
