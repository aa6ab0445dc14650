// Writers for result formats: JSON, XML, CSV, TSV and text tables.

#ifndef KG_CORE_SPARQL_RESULTS_H_
#define KG_CORE_SPARQL_RESULTS_H_

#include <string>
#include <vector>

#include "kg_core/sparql/query_result.h"

namespace kg_core {

// https://www.w3.org/TR/sparql11-results-json/
// Triples become rows of ?subject ?predicate ?object.
std::string ToJson(const QueryResult& result);

// https://www.w3.org/TR/rdf-sparql-XMLres/ Control characters not allowed in
// XML become U+FFFD.
std::string ToXml(const QueryResult& result);

// https://www.w3.org/TR/sparql11-results-csv-tsv/ CSV has values without types.
// ASK gives one row of ?answer, since the recommendation defines no form for
// it.
std::string ToCsv(const QueryResult& result);
std::string ToTsv(const QueryResult& result);

// A table for terminals, with terms in Turtle syntax and the prefixes of
// rdf/namespaces.h; the last line gives the number of rows. ASK gives "yes" or
// "no"; triples are written as Turtle.
std::string ToTextTable(const QueryResult& result);

// Sorted by subject, with only the prefixes that are used.
// https://www.w3.org/TR/turtle/
std::string TriplesToTurtle(const std::vector<Triple>& triples);

// A result format, with its name in requests and its media type.
struct ResultFormat {
  const char* name;        // "json", "xml", "csv", "tsv", "text".
  const char* media_type;  // RFC 6838
  std::string (*write)(const QueryResult& result);
};
const std::vector<ResultFormat>& ResultFormats();

// Converts triples to rows of ?subject ?predicate ?object; other results are
// returned unchanged.
QueryResult AsRows(const QueryResult& result);

}  // namespace kg_core

#endif  // KG_CORE_SPARQL_RESULTS_H_
