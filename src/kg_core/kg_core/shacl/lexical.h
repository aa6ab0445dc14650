// Does a literal's lexical form belong to its datatype? XML Schema part 2.
// https://www.w3.org/TR/xmlschema11-2/#built-in-datatypes

#ifndef KG_CORE_SHACL_LEXICAL_H_
#define KG_CORE_SHACL_LEXICAL_H_

#include "kg_base/text/regex.h"
#include "kg_core/rdf/term.h"

namespace kg_core::shacl {

// True for datatypes that are not known here. `regexes` keeps the compiled
// patterns.
bool IsLexical(const Term& literal, kg_base::RegexCache& regexes);

}  // namespace kg_core::shacl

#endif  // KG_CORE_SHACL_LEXICAL_H_
