// Test of RDF datasets for equality up to blank node labels.
// https://www.w3.org/TR/rdf11-concepts/#graph-isomorphism

#ifndef KG_CORE_SPARQL_ISOMORPHISM_H_
#define KG_CORE_SPARQL_ISOMORPHISM_H_

#include <vector>

#include "kg_core/rdf/store.h"

namespace kg_core {

// Exact: color refinement distinguishes blank nodes by their statements;
// remaining ties are resolved by backtracking. Meant for results and tests, not
// for large graphs with many indistinguishable blank nodes (exponential).
// Duplicate statements count once.
bool IsIsomorphic(const std::vector<Statement>& a,
                  const std::vector<Statement>& b);

}  // namespace kg_core

#endif  // KG_CORE_SPARQL_ISOMORPHISM_H_
