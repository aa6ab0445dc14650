// Globally unique blank nodes: not used in the store, in another query or in
// another process.

#ifndef KG_CORE_SPARQL_FRESH_BLANK_H_
#define KG_CORE_SPARQL_FRESH_BLANK_H_

#include "kg_core/rdf/term.h"

namespace kg_core::sparql {

// Returns a new blank node on each call; thread-safe. Its label has a counter
// and 96 random bits that distinguish processes.
Term FreshBlank();

}  // namespace kg_core::sparql

#endif  // KG_CORE_SPARQL_FRESH_BLANK_H_
