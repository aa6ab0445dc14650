// SHACL over the facts: shapes are Turtle in the vocabulary graph, validated on
// the state a transaction would leave, before it commits.
// https://www.w3.org/TR/shacl/
//
// Constraint components available now: class, datatype, nodeKind, minCount,
// maxCount, min/maxInclusive, min/maxExclusive, minLength, maxLength, pattern,
// in, hasValue, lessThan, lessThanOrEquals, node, property, or, xone, and, not,
// with targets targetClass (also through rdfs:subClassOf) and targetNode and
// paths of one predicate. A shape that uses another component is refused when
// it is loaded: nothing is silently unchecked.

#ifndef KG_CORE_MISSION_VALIDATOR_H_
#define KG_CORE_MISSION_VALIDATOR_H_

#include <string>
#include <vector>

#include "kg_core/rdf/graph_view.h"

namespace kg_core {

struct Violation {
  Term focus_node;
  Term path;              // Empty IRI for a node shape.
  Term value;             // Empty IRI where none is to blame.
  Term source_shape;      // Often a blank node;
  Term named_shape;       // the nearest shape around it that has a name.
  std::string component;  // "sh:MinCountConstraintComponent"
  std::string message;

  std::string Line() const;  // "ex:alpha ex:usesPolicy: ... (shape ...)"
};

// Validates every focus node of `view`'s facts graph against the shapes of its
// vocabulary graph. Throws InputError if a shape itself cannot be used.
std::vector<Violation> Validate(const GraphView& view);

}  // namespace kg_core

#endif  // KG_CORE_MISSION_VALIDATOR_H_
