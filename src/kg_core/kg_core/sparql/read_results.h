// Readers for the result formats written by results.h, used for results of
// other stores and of the W3C tests.

#ifndef KG_CORE_SPARQL_READ_RESULTS_H_
#define KG_CORE_SPARQL_READ_RESULTS_H_

#include <string_view>

#include "kg_core/sparql/query_result.h"

namespace kg_core {

// All throw InputError that states what was expected. Unknown members and
// elements are skipped.

// https://www.w3.org/TR/sparql11-results-json/
QueryResult ReadJsonResult(std::string_view text);
// https://www.w3.org/TR/rdf-sparql-XMLres/; no DTD, no entities but XML's own.
QueryResult ReadXmlResult(std::string_view text);
// https://www.w3.org/TR/sparql11-results-csv-tsv/; every CSV value is read as
// xsd:string, since CSV has no types, and an empty value is unbound.
QueryResult ReadCsvResult(std::string_view text);
QueryResult ReadTsvResult(std::string_view text);

}  // namespace kg_core

#endif  // KG_CORE_SPARQL_READ_RESULTS_H_
