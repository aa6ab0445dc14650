// A SPARQL token. https://www.w3.org/TR/sparql11-query/#sparqlGrammar
// (terminals [139]-[173])

#ifndef KG_CORE_SPARQL_TOKEN_H_
#define KG_CORE_SPARQL_TOKEN_H_

#include <string>

namespace kg_core::sparql {

struct QueryPosition {
  int line = 1;    // From 1.
  int column = 1;  // From 1, in characters.
};

struct Token {
  enum class Kind {
    kEnd,
    kIri,           // text: IRI reference, unresolved, escapes undone.
    kPrefixedName,  // prefix, text: local name, escapes undone.
    kBlankLabel,    // text: the label.
    kVariable,      // text: the name.
    kString,        // text: the value.
    kLanguageTag,   // text: lower case, without '@'.
    kInteger,       // text: as written, without sign (likewise below).
    kDecimal,
    kDouble,
    kWord,         // text: a keyword or 'a', as written.
    kPunctuation,  // text: "{", "&&", "^^", ...
  };

  Kind kind = Kind::kEnd;
  std::string text;
  std::string prefix;
  QueryPosition position;
};

}  // namespace kg_core::sparql

#endif  // KG_CORE_SPARQL_TOKEN_H_
