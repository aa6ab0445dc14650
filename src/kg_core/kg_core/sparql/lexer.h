// Tokenizer for SPARQL. https://www.w3.org/TR/sparql11-query/#sparqlGrammar

#ifndef KG_CORE_SPARQL_LEXER_H_
#define KG_CORE_SPARQL_LEXER_H_

#include <string_view>
#include <vector>

#include "kg_core/sparql/token.h"

namespace kg_core::sparql {

// All tokens of `text`, kEnd last. Throws InputError "line:column: what was
// expected".
std::vector<Token> Tokenize(std::string_view text);

}  // namespace kg_core::sparql

#endif  // KG_CORE_SPARQL_LEXER_H_
