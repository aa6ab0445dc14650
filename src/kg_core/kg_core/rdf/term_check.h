// What makes a term RDF 1.1: an absolute IRI of the characters that an IRI may
// hold, a well-formed language tag, text that is Unicode. A store holds such
// terms only, so whatever it exports can be imported.
//
// https://www.w3.org/TR/rdf11-concepts/#section-IRIs, #section-Graph-Literal
// https://www.w3.org/TR/n-triples/#n-triples-grammar

#ifndef KG_CORE_RDF_TERM_CHECK_H_
#define KG_CORE_RDF_TERM_CHECK_H_

#include <optional>
#include <string>
#include <string_view>

#include "kg_core/rdf/term.h"

namespace kg_core {

// What is wrong with the term, for a message ("IRI with the character U+0020;
// expected ..."); nullopt if it is RDF.
std::optional<std::string> FindTermFault(const Term& term);

// The same for the characters of an IRI reference, which may be relative.
std::optional<std::string> FindIriFault(std::string_view reference);

// Is it of the form of LANGTAG without its '@' ("en", "zh-hans-x-old")?
bool IsLanguageTag(std::string_view text);

}  // namespace kg_core

#endif  // KG_CORE_RDF_TERM_CHECK_H_
