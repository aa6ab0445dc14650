// Results in the forms that programs and people read.

#ifndef KG_CORE_SPARQL_RESULTS_H_
#define KG_CORE_SPARQL_RESULTS_H_

#include <string>
#include <vector>

#include "kg_core/sparql/query_result.h"

namespace kg_core {

// https://www.w3.org/TR/sparql11-results-json/
// Triples become rows of ?subject ?predicate ?object.
std::string ToJson(const QueryResult& result);

// https://www.w3.org/TR/rdf-sparql-XMLres/
// Control characters that XML cannot have become U+FFFD.
std::string ToXml(const QueryResult& result);

// https://www.w3.org/TR/sparql11-results-csv-tsv/
// CSV is values without their types. Of ASK: one row of ?answer, as the
// recommendation knows no other.
std::string ToCsv(const QueryResult& result);
std::string ToTsv(const QueryResult& result);

// A table for terminals, terms in Turtle's syntax with our prefixes; its last
// line counts the rows. Of ASK: "yes" or "no". Triples: as Turtle.
std::string ToTextTable(const QueryResult& result);

// Sorted by subject, with those of our prefixes that are used.
// https://www.w3.org/TR/turtle/
std::string TriplesToTurtle(const std::vector<Triple>& triples);

// A way to write rows, by its name in requests and its media type.
struct ResultFormat {
  const char* name;        // "json", "xml", "csv", "tsv", "text".
  const char* media_type;  // RFC 6838
  std::string (*write)(const QueryResult& result);
};
const std::vector<ResultFormat>& ResultFormats();

// Triples as rows of ?subject ?predicate ?object; others as they are.
QueryResult AsRows(const QueryResult& result);

}  // namespace kg_core

#endif  // KG_CORE_SPARQL_RESULTS_H_
