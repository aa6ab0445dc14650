// Evaluates patterns by pushing solutions one by one through the algebra.
// https://www.w3.org/TR/sparql11-query/#sparqlAlgebraEval
//
// Bindings found so far are passed into the next pattern (index nested loop
// join); a pattern marked `materialise` is evaluated once on its own and hash
// joined (see algebra.h for the criterion).

#ifndef KG_CORE_SPARQL_EVALUATOR_H_
#define KG_CORE_SPARQL_EVALUATOR_H_

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "absl/container/flat_hash_map.h"
#include "absl/container/flat_hash_set.h"
#include "absl/functional/function_ref.h"
#include "kg_core/sparql/active_graph.h"
#include "kg_core/sparql/budget.h"
#include "kg_core/sparql/expression.h"
#include "kg_core/sparql/join_table.h"
#include "kg_core/sparql/query.h"
#include "kg_core/sparql/term_table.h"

namespace kg_core::sparql {

// The dataset of a query as graph ids.
struct DatasetIds {
  std::vector<TermId> default_graphs;
  std::optional<std::vector<TermId>> named_graphs;  // nullopt: all graphs
  TermId unnamed_graph = kNoTerm;                   // except this one.
};

class PatternEvaluator {
 public:
  // Receives a solution; returning false stops the evaluation.
  using Emit = absl::FunctionRef<bool(Row&)>;

  PatternEvaluator(const Query* query, TermTable* terms, DatasetIds dataset,
                   QueryBudget* budget);

  // Calls `emit` with the columns of each solution of the query (for ASK: with
  // the whole solution).
  void Run(Emit emit);
  // Enables tracing: at every solution, `matched` holds the triples of the
  // default graph that its patterns matched. For a property path these are the
  // triples of one shortest path (path_witness.h), for a group those of all its
  // members. Triples examined by EXISTS and MINUS are not included.
  void Trace(std::vector<Quad>* matched) { matched_ = matched; }
  const ActiveGraph& default_graph() const { return default_graph_; }

 private:
  // The order in which the triples of a basic graph pattern are matched, and
  // the filters that can be decided before step i.
  struct Plan {
    std::vector<const TriplePattern*> steps;
    std::vector<std::vector<const Expression*>> filters;
  };
  struct BasicRun;
  struct Sorted;
  struct Group;

  // Each returns false if `emit` stopped the evaluation, and restores `row`.
  bool Evaluate(const GraphPattern& p, const ActiveGraph& g, Row* row,
                Emit emit);
  bool EvaluateBody(const GraphPattern& p, const ActiveGraph& g, Row* row,
                    Emit emit);
  bool LeftJoin(const GraphPattern& p, const ActiveGraph& g, Row* row,
                Emit emit);
  bool Minus(const GraphPattern& p, const ActiveGraph& g, Row* row, Emit emit);
  bool Extend(const GraphPattern& p, const ActiveGraph& g, Row* row, Emit emit);
  bool Graph(const GraphPattern& p, Row* row, Emit emit);
  bool Values(const GraphPattern& p, Row* row, Emit emit);
  bool HoldAll(const std::vector<Expression>& filters, const ActiveGraph& g,
               Row* row);
  bool HasSolution(const GraphPattern& p, const Solution& solution);
  JoinTable& GetTable(const GraphPattern& p, const ActiveGraph& g);

  // Graphs (named_graphs.cc).
  const ActiveGraph* NamedGraph(TermId graph);
  std::vector<TermId> CandidateGraphs(const GraphPattern& p, const Row& row);

  // Basic graph patterns (basic_pattern.cc).
  bool Basic(const GraphPattern& p, const ActiveGraph& g, Row* row, Emit emit);
  bool Step(const BasicRun& run, std::size_t step);
  bool PathStep(const BasicRun& run, std::size_t step,
                const TriplePattern& triple);
  const Plan& GetPlan(const GraphPattern& p, const ActiveGraph& g,
                      const Row& row);
  double Cost(const TriplePattern& triple, const ActiveGraph& g,
              const VariableSet& bound) const;
  TermId GetValue(const VarOrTerm& node, const Row& row) const;
  TermId GetConstant(const VarOrTerm& node) const;

  // Subqueries and solution modifiers (select.cc).
  bool RunSelect(const SelectQuery& select, const ActiveGraph& g, Emit emit);
  bool Solutions(const SelectQuery& select, const ActiveGraph& g, Emit emit);
  bool Grouped(const SelectQuery& select, const ActiveGraph& g, Emit emit);
  Group NewGroup(const SelectQuery& select, const Row& key);
  bool FinishRow(const SelectQuery& select, const ActiveGraph& g, Row* row,
                 Emit emit);
  void RankKeys(std::vector<Sorted>* all);
  std::vector<Sorted> SortedSolutions(const SelectQuery& select,
                                      const ActiveGraph& g);

  const Query* query_;
  TermTable* terms_;
  DatasetIds dataset_;
  QueryBudget* budget_;
  std::vector<Quad>* matched_ = nullptr;  // Set by Trace(), else null.
  ExpressionEvaluator expressions_;
  std::vector<TermId> constants_;  // Ids of the query's constants.
  ActiveGraph default_graph_;
  absl::flat_hash_map<TermId, std::unique_ptr<ActiveGraph>> graphs_;
  absl::flat_hash_map<const GraphPattern*, std::unique_ptr<Plan>> plans_;
  absl::flat_hash_map<std::pair<const GraphPattern*, const ActiveGraph*>,
                      std::unique_ptr<JoinTable>>
      tables_;
};

}  // namespace kg_core::sparql

#endif  // KG_CORE_SPARQL_EVALUATOR_H_
