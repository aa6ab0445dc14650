// Validity of lexical forms by XML Schema part 2.
// https://www.w3.org/TR/xmlschema11-2/#built-in-datatypes

#ifndef KG_CORE_SHACL_LEXICAL_H_
#define KG_CORE_SHACL_LEXICAL_H_

#include "kg_base/text/regex.h"
#include "kg_core/rdf/term.h"

namespace kg_core::shacl {

// True if the lexical form belongs to the datatype, and for unknown datatypes.
// `regexes` caches compiled patterns.
bool IsLexical(const Term& literal, kg_base::RegexCache& regexes);

}  // namespace kg_core::shacl

#endif  // KG_CORE_SHACL_LEXICAL_H_
