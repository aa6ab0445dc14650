// The data graph of a validation: one graph of a view, and the graphs with
// class information.

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
  std::string graph;  // Graph with focus nodes and their values.
  // Graphs from which rdf:type and rdfs:subClassOf are read for sh:class, and
  // rdfs:subClassOf for targets. Usually includes `graph`.
  std::vector<std::string> class_graphs;
  // Removed statements to treat as still in `graph`; null for none.
  const std::vector<Statement>* removed = nullptr;
};

enum class Direction { kForward, kBackward };

// The nodes reached from `node` by one step along (or against) `predicate`.
std::vector<Term> Step(const DataGraph& data, const Term& node,
                       const Term& predicate, Direction direction);

// `top` and all its subclasses by rdfs:subClassOf in `graphs`.
std::set<Term> ClassesBelow(const GraphView& view,
                            const std::vector<std::string>& graphs,
                            const Term& top);

}  // namespace kg_core::shacl

#endif  // KG_CORE_SHACL_DATA_GRAPH_H_
