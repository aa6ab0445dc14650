// Reads the result formats that results.h writes: what other stores answer, and
// what the W3C tests expect.

#ifndef KG_CORE_SPARQL_READ_RESULTS_H_
#define KG_CORE_SPARQL_READ_RESULTS_H_

#include <string_view>

#include "kg_core/sparql/query_result.h"

namespace kg_core {

// All throw InputError that says what was expected. Members and elements that
// are not known are skipped.

// https://www.w3.org/TR/sparql11-results-json/
QueryResult ReadJsonResult(std::string_view text);
// https://www.w3.org/TR/rdf-sparql-XMLres/; no DTD, no entities but XML's own.
QueryResult ReadXmlResult(std::string_view text);
// https://www.w3.org/TR/sparql11-results-csv-tsv/; every value of CSV is an
// xsd:string, since CSV does not say, and an empty one is unbound.
QueryResult ReadCsvResult(std::string_view text);
QueryResult ReadTsvResult(std::string_view text);

}  // namespace kg_core

#endif  // KG_CORE_SPARQL_READ_RESULTS_H_
