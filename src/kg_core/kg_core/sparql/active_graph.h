// The graph that patterns are matched with: one named graph, or several merged.
// https://www.w3.org/TR/sparql11-query/#rdfDataset

#ifndef KG_CORE_SPARQL_ACTIVE_GRAPH_H_
#define KG_CORE_SPARQL_ACTIVE_GRAPH_H_

#include <cstddef>
#include <vector>

#include "absl/functional/function_ref.h"
#include "kg_core/sparql/budget.h"
#include "kg_core/sparql/term_table.h"

namespace kg_core::sparql {

class ActiveGraph {
 public:
  ActiveGraph(const GraphView* view, std::vector<TermId> graphs,
              QueryBudget* budget);

  // Every triple that matches, once, though several graphs have it. The graph
  // of `pattern` does not count. False if `visit` was: stop.
  bool Match(const Quad& pattern,
             absl::FunctionRef<bool(const Quad&)> visit) const;
  std::size_t Estimate(const Quad& pattern) const;
  // All subjects and objects, each once.
  std::vector<TermId> Nodes() const;
  bool HasNode(TermId node) const;
  bool empty() const;

 private:
  bool HasMatch(const Quad& pattern) const;
  bool HasBefore(const Quad& quad, std::size_t index) const;

  const GraphView* view_;
  std::vector<TermId> graphs_;
  QueryBudget* budget_;
};

}  // namespace kg_core::sparql

#endif  // KG_CORE_SPARQL_ACTIVE_GRAPH_H_
