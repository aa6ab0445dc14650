// The active graph against which patterns are matched: one named graph, or
// several merged.
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

  // Visits every matching triple once, even if several graphs contain it. The
  // graph of `pattern` is ignored. Returns false if `visit` returned false
  // (stop).
  bool Match(const Quad& pattern,
             absl::FunctionRef<bool(const Quad&)> visit) const;
  std::size_t Estimate(const Quad& pattern) const;
  // All nodes (subjects and objects), each once.
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
