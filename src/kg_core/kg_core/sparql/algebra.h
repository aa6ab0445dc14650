// Static analysis of patterns, before evaluation.
//
// The evaluator passes the bindings found so far into the next pattern, so that
// a join is an index nested loop. This agrees with the bottom-up semantics of
// the specification only if the outer bindings cannot change the pattern's own
// solutions (no filter, no right side of an OPTIONAL ... that would see a
// variable it does not bind itself). Prepare() detects the other patterns and
// marks them `materialise`: evaluated separately, then joined.
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
// The variables mentioned in an expression, including those in EXISTS.
VariableSet CollectVariables(const Expression& expression);
// The variables bound or mentioned anywhere within `pattern`.
VariableSet MentionedVariables(const GraphPattern& pattern);

}  // namespace kg_core::sparql

#endif  // KG_CORE_SPARQL_ALGEBRA_H_
