// Incremental validation: the focus nodes that a change of the data can affect.
//
// Validating a focus node reads triples only in a few ways: a step of a path,
// of a property pair or of a class, from a node X that a path P reaches from
// the focus node. So for each shape with a target, all such reads (P, predicate
// or any, direction) are listed. A changed triple that matches a read affects
// the focus nodes from which P reaches X, before or after the change: P is
// walked backwards over the new state with the removed triples still in place.
// A node that became a target is affected as well. Exactly these nodes are
// checked; the result of all others is unchanged.
//
// A change of rdfs:subClassOf affects all focus nodes.

#ifndef KG_CORE_SHACL_CHANGES_H_
#define KG_CORE_SHACL_CHANGES_H_

#include <map>
#include <optional>
#include <set>
#include <vector>

#include "kg_core/rdf/store.h"
#include "kg_core/shacl/data_graph.h"
#include "kg_core/shacl/shape.h"
#include "kg_core/shacl/violation.h"

namespace kg_core::shacl {

struct GraphChange {
  std::vector<Statement> added;
  std::vector<Statement> removed;
};

// For each shape, the nodes to check again; some may no longer be targets.
// nullopt if everything has to be checked. `data` is the state after the
// change.
using TouchedNodes = std::map<Term, std::set<Term>>;
std::optional<TouchedNodes> FindTouched(const DataGraph& data,
                                        const ShapeGraph& shapes,
                                        const GraphChange& change);

// The violations at the touched focus nodes, in the order of a full validation.
// If the state before the change had none, these are all violations.
std::vector<Violation> ValidateTouched(const DataGraph& data,
                                       const ShapeGraph& shapes,
                                       const GraphChange& change);

}  // namespace kg_core::shacl

#endif  // KG_CORE_SHACL_CHANGES_H_
