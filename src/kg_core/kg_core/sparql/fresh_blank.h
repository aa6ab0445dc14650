// Blank nodes that are unique: neither the store, nor another query or
// process.

#ifndef KG_CORE_SPARQL_FRESH_BLANK_H_
#define KG_CORE_SPARQL_FRESH_BLANK_H_

#include "kg_core/rdf/term.h"

namespace kg_core::sparql {

// Another one with each call, from any thread: a count, and 96 random bits that
// keep processes apart.
Term FreshBlank();

}  // namespace kg_core::sparql

#endif  // KG_CORE_SPARQL_FRESH_BLANK_H_
