// Evaluates expressions over one solution.
// https://www.w3.org/TR/sparql11-query/#evaluation
//
// nullptr (or std::nullopt) stands for an unbound variable or SPARQL's type
// error; logical operators follow the three-valued table of #evaluation.

#ifndef KG_CORE_SPARQL_EXPRESSION_H_
#define KG_CORE_SPARQL_EXPRESSION_H_

#include <deque>
#include <functional>
#include <optional>
#include <vector>

#include "kg_core/sparql/active_graph.h"
#include "kg_core/sparql/functions.h"
#include "kg_core/sparql/query.h"
#include "kg_core/sparql/term_table.h"

namespace kg_core::sparql {

// A solution: the term of every variable of the query, kNoTerm = unbound.
using Row = std::vector<TermId>;

// The input of an expression: a solution and the active graph.
struct Solution {
  Row& row;
  const ActiveGraph& graph;
};

class ExpressionEvaluator {
 public:
  // Returns whether `pattern` has a solution compatible with the given one.
  using Exists = std::function<bool(const GraphPattern&, const Solution&)>;

  ExpressionEvaluator(const Query* query, TermTable* terms, QueryBudget* budget,
                      Exists exists);

  // True if the effective boolean value of the expression is true.
  bool Holds(const Expression& expression, const Solution& solution);
  // The value of the expression as an id; kNoTerm for an error.
  TermId Evaluate(const Expression& expression, const Solution& solution);
  // Begins a new solution: BNODE("x") yields a new node from here on.
  void BeginRow() { context_.blanks_of_row.clear(); }

 private:
  const Term* Value(const Expression& e, const Solution& solution);
  const Term* Variable(int variable, const Solution& solution) const;
  std::optional<bool> Truth(const Expression& e, const Solution& solution);
  const Term* Logical(const Expression& e, const Solution& solution);
  const Term* Comparison(const Expression& e, const Solution& solution);
  const Term* Membership(const Expression& e, const Solution& solution);
  const Term* Arithmetic(const Expression& e, const Solution& solution);
  const Term* Sign(const Expression& e, const Solution& solution);
  const Term* Call(const Expression& e, const Solution& solution);
  const Term* Form(const Expression& e, const Solution& solution);
  // Keeps a computed term until the outermost evaluation ends.
  const Term* Own(Term term);
  const Term* Own(std::optional<bool> truth);

  const Query* query_;
  TermTable* terms_;
  QueryBudget* budget_;
  Exists exists_;
  FunctionContext context_;
  std::deque<Term> computed_;
};

}  // namespace kg_core::sparql

#endif  // KG_CORE_SPARQL_EXPRESSION_H_
