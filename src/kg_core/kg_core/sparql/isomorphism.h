// Are two RDF datasets the same but for the labels of their blank nodes?
// https://www.w3.org/TR/rdf11-concepts/#graph-isomorphism

#ifndef KG_CORE_SPARQL_ISOMORPHISM_H_
#define KG_CORE_SPARQL_ISOMORPHISM_H_

#include <vector>

#include "kg_core/rdf/store.h"

namespace kg_core {

// Exact: blank nodes are told apart by what is said of them, and where that
// leaves a choice, all choices are tried. For results and tests, not for large
// graphs full of look-alike blank nodes. Statements count once.
bool IsIsomorphic(const std::vector<Statement>& a,
                  const std::vector<Statement>& b);

}  // namespace kg_core

#endif  // KG_CORE_SPARQL_ISOMORPHISM_H_
