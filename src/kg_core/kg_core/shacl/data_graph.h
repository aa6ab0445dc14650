// What validation sees of the data: one graph of a view, and where the classes
// of things stand.

#ifndef KG_CORE_SHACL_DATA_GRAPH_H_
#define KG_CORE_SHACL_DATA_GRAPH_H_

#include <set>
#include <string>
#include <vector>

#include "kg_core/rdf/graph_view.h"
#include "kg_core/rdf/store.h"

namespace kg_core::shacl {

struct DataGraph {
  const GraphView& view;
  std::string graph;  // Focus nodes and their values.
  // Where rdf:type and rdfs:subClassOf are read for sh:class; rdfs:subClassOf
  // also for targets. Usually holds `graph`.
  std::vector<std::string> class_graphs;
  // Statements seen as if they were still in `graph`; null for none.
  const std::vector<Statement>* removed = nullptr;
};

enum class Direction { kForward, kBackward };

// What one step along (or against) `predicate` reaches from `node`.
std::vector<Term> Step(const DataGraph& data, const Term& node,
                       const Term& predicate, Direction direction);

// `top` and every class below it, by rdfs:subClassOf of `graphs`.
std::set<Term> ClassesBelow(const GraphView& view,
                            const std::vector<std::string>& graphs,
                            const Term& top);

}  // namespace kg_core::shacl

#endif  // KG_CORE_SHACL_DATA_GRAPH_H_
