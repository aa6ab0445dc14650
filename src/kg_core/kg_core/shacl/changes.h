// Which focus nodes can a change of the data have touched?
//
// Validating a focus node reads triples in a few ways only: a step of a path,
// of a property pair or of a class, from a node X that a path P reaches from
// the focus node. So for each shape with a target, all such reads (P, predicate
// or any, direction) are listed. A changed triple that a read would have seen
// touches the focus nodes from which P reaches X, before or after the change:
// P is walked backwards over the state after it with the removed triples still
// in place. A node that only became a target is touched as well. Exactly these
// are checked; for all others the result is what it was before.
//
// A change of rdfs:subClassOf touches everything.

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

// By shape, the nodes that may have to be checked again; some may be no targets
// of it now. Nothing if everything has to be. `data` is the state after.
using TouchedNodes = std::map<Term, std::set<Term>>;
std::optional<TouchedNodes> FindTouched(const DataGraph& data,
                                        const ShapeGraph& shapes,
                                        const GraphChange& change);

// The violations at the touched focus nodes, in the order of a whole
// validation; all there are if there was none before the change.
std::vector<Violation> ValidateTouched(const DataGraph& data,
                                       const ShapeGraph& shapes,
                                       const GraphChange& change);

}  // namespace kg_core::shacl

#endif  // KG_CORE_SHACL_CHANGES_H_
