// Results in the forms that programs and people read.

#ifndef KG_CORE_SPARQL_RESULTS_H_
#define KG_CORE_SPARQL_RESULTS_H_

#include <string>

#include "kg_core/sparql/query_engine.h"

namespace kg_core {

// https://www.w3.org/TR/sparql11-results-json/
std::string ToJson(const QueryResult& result);

// A table for terminals, terms in Turtle's syntax with our prefixes; its last
// line counts the rows. Of ASK: "yes" or "no".
std::string ToTextTable(const QueryResult& result);

}  // namespace kg_core

#endif  // KG_CORE_SPARQL_RESULTS_H_
