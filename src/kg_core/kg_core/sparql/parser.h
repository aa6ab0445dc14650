// Reads a SPARQL query. https://www.w3.org/TR/sparql11-query/#sparqlGrammar

#ifndef KG_CORE_SPARQL_PARSER_H_
#define KG_CORE_SPARQL_PARSER_H_

#include <string_view>

#include "kg_core/sparql/query.h"
#include "kg_core/sparql/update.h"

namespace kg_core::sparql {

// Our prefixes (rdf/namespaces.h) are known without being declared. `nesting`
// bounds brackets within brackets. Throws InputError "line:column: what was
// expected", or "line:column: ... is not available".
Query ParseQuery(std::string_view text, int nesting);

// Likewise an update request. Queries and updates do not know each other's
// keywords.
UpdateRequest ParseUpdate(std::string_view text, int nesting);

}  // namespace kg_core::sparql

#endif  // KG_CORE_SPARQL_PARSER_H_
