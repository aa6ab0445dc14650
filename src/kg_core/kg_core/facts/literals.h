// Literals: is the lexical form well-formed, and what is the value? And back.

#ifndef KG_CORE_FACTS_LITERALS_H_
#define KG_CORE_FACTS_LITERALS_H_

#include <optional>

#include "kg_core/rdf/term.h"

namespace kg_core {

// Does the lexical form belong to the datatype? True for datatypes that are
// not known here. https://www.w3.org/TR/rdf11-concepts/#dfn-ill-typed
bool IsWellFormed(const Term& literal);

// Values; nothing if `term` is not a well-formed literal of that type.
std::optional<double> UnixSeconds(const Term& term);      // xsd:dateTime
std::optional<double> DurationSeconds(const Term& term);  // xsd:duration
std::optional<bool> BooleanValue(const Term& term);       // xsd:boolean

// The xsd:dateTime of a Unix time, in UTC.
Term DateTimeLiteral(double unix_s);

}  // namespace kg_core

#endif  // KG_CORE_FACTS_LITERALS_H_
