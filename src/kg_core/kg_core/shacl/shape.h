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

// What the value of a component's parameter must be.
enum class ParameterKind {
  kAny,
  kIri,
  kNodeKind,
  kLiteral,
  kCount,    // An integer of at least 0.
  kPattern,  // A regular expression; sh:flags belongs to it.
  kTrue,     // A boolean; no constraint if it is false.
  kList,
  kLanguages,
  kShape,
  kPropertyShape,
  kShapeList,
  kQualified  // A count of values that conform to sh:qualifiedValueShape.
};

// Does a parameter of this kind name other shapes?
bool RefersToShapes(ParameterKind kind);

// A constraint component is a row of a table (components.cc): the name of its
// parameter, how the parameter is read, and the function that checks it.
struct ConstraintComponent {
  const char* parameter;  // Local name in sh:, e.g. "minCount".
  const char* name;       // "MinCountConstraintComponent"
  ParameterKind kind;
  void (*check)(const ConstraintCheck& check);
  bool most_one = false;       // At most one value in a shape.
  bool property_only = false;  // Not in a node shape.
};

// One constraint of a shape. Shapes among `terms` are in the shape graph.
struct Constraint {
  const ConstraintComponent* component = nullptr;
  std::vector<Term> terms;  // The parameter's value, or its list's members.
  std::size_t count = 0;    // kCount and kQualified: its value.
  std::string flags;        // Of sh:pattern.
  // sh:closed: the properties that may be there;
  // kQualified: the sibling shapes that a counted value must not conform to.
  std::vector<Term> others;
};

struct Shape {
  Term id;
  Term named;  // `id` if it is an IRI, else the nearest one around it.
  std::optional<PropertyPath> path;  // A property shape's.
  std::vector<Term> target_classes;  // With the implicit one.
  std::vector<Term> target_nodes;
  std::vector<Term> target_subjects_of;
  std::vector<Term> target_objects_of;
  Term severity;
  std::string message;  // One of `messages` to show, may be empty.
  std::vector<Term> messages;
  bool deactivated = false;
  std::vector<Constraint> constraints;
};

// By id, so in a stable order.
using ShapeGraph = std::map<Term, Shape>;

}  // namespace kg_core::shacl

#endif  // KG_CORE_SHACL_SHAPE_H_
