// Triples built from solutions: CONSTRUCT, DESCRIBE and update templates.
// https://www.w3.org/TR/sparql11-query/#construct, #describe

#ifndef KG_CORE_SPARQL_CONSTRUCT_H_
#define KG_CORE_SPARQL_CONSTRUCT_H_

#include <vector>

#include "absl/functional/function_ref.h"
#include "kg_core/sparql/evaluator.h"
#include "kg_core/sparql/query.h"
#include "kg_core/sparql/query_result.h"
#include "kg_core/sparql/term_table.h"

namespace kg_core::sparql {

// Instantiates templates with the terms of solutions.
class TemplateInstantiator {
 public:
  TemplateInstantiator(const Query* query, TermTable* terms);

  // Calls `give` with each quad that the templates yield for `solution`; graph
  // kNoTerm means the default graph. Quads with an unbound variable, and quads
  // that are not valid RDF, are skipped. Each solution gets fresh blank nodes.
  void Run(const std::vector<QuadTemplate>& templates, const Row& solution,
           absl::FunctionRef<void(const Quad&)> give);

 private:
  TermId GetValue(const VarOrTerm& node);
  bool IsRdf(const Quad& quad) const;

  const Query* query_;
  TermTable* terms_;
  std::vector<TermId> constants_;
  Row row_;
};

// The context in which a query is run.
struct QueryRun {
  const Query& query;
  PatternEvaluator* evaluator;
  TermTable* terms;
  QueryBudget* budget;
};

// The triples of a CONSTRUCT query, without duplicates.
std::vector<Triple> Construct(const QueryRun& run);

// The concise bounded descriptions of the resources of a DESCRIBE query: all
// triples about each in the default graph, and recursively about the blank
// nodes they refer to. https://www.w3.org/Submission/CBD/ (without reified
// statements)
std::vector<Triple> Describe(const QueryRun& run);

}  // namespace kg_core::sparql

#endif  // KG_CORE_SPARQL_CONSTRUCT_H_
