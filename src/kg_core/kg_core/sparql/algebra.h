// What is known of a pattern before it is evaluated.
//
// The evaluator passes the bindings found so far into the pattern that comes
// next, so that a join is a walk along an index. This gives the bottom-up
// semantics of the specification only where the pattern cannot tell the
// difference (no filter, no right side of an OPTIONAL ... that would see a
// variable it does not bind itself). Prepare() finds out, and marks the others
// to be evaluated alone and joined: `materialise`.
// https://www.w3.org/TR/sparql11-query/#sparqlAlgebraEval

#ifndef KG_CORE_SPARQL_ALGEBRA_H_
#define KG_CORE_SPARQL_ALGEBRA_H_

#include "kg_core/sparql/query.h"

namespace kg_core::sparql {

// Sets `possible`, `certain` and `materialise` in the whole of `select`, moves
// filters down to where their variables become bound, and VALUES to the front.
void Prepare(SelectQuery* select);

// The variables visible outside of `pattern`.
// https://www.w3.org/TR/sparql11-query/#variableScope
VariableSet VisibleVariables(const GraphPattern& pattern);
// The variables that an expression mentions, those of EXISTS too.
VariableSet CollectVariables(const Expression& expression);
// The variables bound or mentioned anywhere within `pattern`.
VariableSet MentionedVariables(const GraphPattern& pattern);

}  // namespace kg_core::sparql

#endif  // KG_CORE_SPARQL_ALGEBRA_H_
