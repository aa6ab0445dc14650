// Literals: validity of lexical forms, and conversion to and from values.

#ifndef KG_CORE_FACTS_LITERALS_H_
#define KG_CORE_FACTS_LITERALS_H_

#include <optional>

#include "kg_core/rdf/term.h"

namespace kg_core {

// True if the lexical form is valid for the datatype, and for unknown
// datatypes. https://www.w3.org/TR/rdf11-concepts/#dfn-ill-typed
bool IsWellFormed(const Term& literal);

// Values; nullopt if `term` is not a well-formed literal of the type given.
std::optional<double> UnixSeconds(const Term& term);      // xsd:dateTime
std::optional<double> DurationSeconds(const Term& term);  // xsd:duration
std::optional<bool> BooleanValue(const Term& term);       // xsd:boolean

// The xsd:dateTime in UTC of a Unix time in seconds.
Term DateTimeLiteral(double unix_s);

}  // namespace kg_core

#endif  // KG_CORE_FACTS_LITERALS_H_
