// Parser for SPARQL queries and updates.
// https://www.w3.org/TR/sparql11-query/#sparqlGrammar

#ifndef KG_CORE_SPARQL_PARSER_H_
#define KG_CORE_SPARQL_PARSER_H_

#include <string_view>

#include "kg_core/sparql/query.h"
#include "kg_core/sparql/update.h"

namespace kg_core::sparql {

// Parses a query. The prefixes of rdf/namespaces.h need no declaration.
// `nesting` bounds the depth of brackets. Throws InputError "line:column: what
// was expected", or "line:column: ... is not available".
Query ParseQuery(std::string_view text, int nesting);

// Parses an update request likewise. Keywords of updates are errors in queries,
// and vice versa.
UpdateRequest ParseUpdate(std::string_view text, int nesting);

}  // namespace kg_core::sparql

#endif  // KG_CORE_SPARQL_PARSER_H_
