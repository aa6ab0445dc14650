// A shape and its constraints, as read from a graph of shapes.
// https://www.w3.org/TR/shacl/#shapes

#ifndef KG_CORE_SHACL_SHAPE_H_
#define KG_CORE_SHACL_SHAPE_H_

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "kg_core/rdf/term.h"
#include "kg_core/shacl/path.h"

namespace kg_core::shacl {

struct ConstraintCheck;

// Required kind of a component's parameter value.
enum class ParameterKind {
  kAny,
  kIri,
  kNodeKind,
  kLiteral,
  kCount,    // An integer of at least 0.
  kPattern,  // A regular expression; sh:flags belongs to it.
  kTrue,     // A boolean; false disables the constraint.
  kList,
  kLanguages,
  kShape,
  kPropertyShape,
  kShapeList,
  kQualified  // A count of values that conform to sh:qualifiedValueShape.
};

// True if parameters of this kind refer to other shapes.
bool RefersToShapes(ParameterKind kind);

// A constraint component is a row of a table (components.cc): the name of its
// parameter, how the parameter is read, and the function that checks it.
struct ConstraintComponent {
  const char* parameter;  // Local name in sh:, e.g. "minCount".
  const char* name;       // "MinCountConstraintComponent"
  ParameterKind kind;
  void (*check)(const ConstraintCheck& check);
  bool most_one = false;       // At most one value per shape.
  bool property_only = false;  // Not allowed in a node shape.
};

// One constraint of a shape. Shapes among `terms` are in the shape graph.
struct Constraint {
  const ConstraintComponent* component = nullptr;
  std::vector<Term> terms;  // The parameter's value, or its list's members.
  std::size_t count = 0;    // kCount and kQualified: its value.
  std::string flags;        // Flags of sh:pattern.
  // sh:closed: the allowed properties; kQualified: the sibling shapes that a
  // counted value must not conform to.
  std::vector<Term> others;
};

struct Shape {
  Term id;
  Term named;  // `id` if it is an IRI, else the nearest enclosing IRI.
  std::optional<PropertyPath> path;  // Only for property shapes.
  std::vector<Term> target_classes;  // Including the implicit class target.
  std::vector<Term> target_nodes;
  std::vector<Term> target_subjects_of;
  std::vector<Term> target_objects_of;
  Term severity;
  std::string message;  // The one of `messages` to show; may be empty.
  std::vector<Term> messages;
  bool deactivated = false;
  std::vector<Constraint> constraints;
};

// Shapes by id, hence in a stable order.
using ShapeGraph = std::map<Term, Shape>;

}  // namespace kg_core::shacl

#endif  // KG_CORE_SHACL_SHAPE_H_
