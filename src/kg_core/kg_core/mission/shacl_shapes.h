// The shapes of the vocabulary graph, read once per validation.
// https://www.w3.org/TR/shacl/#shapes
//
// A constraint component is a row of a table (shacl_components.cc): the name of
// its parameter, how the parameter is read, and the function that checks it.

#ifndef KG_CORE_MISSION_SHACL_SHAPES_H_
#define KG_CORE_MISSION_SHACL_SHAPES_H_

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "kg_core/mission/validator.h"
#include "kg_core/rdf/graph_view.h"
#include "kg_core/rdf/term.h"

namespace kg_core::shacl {

struct Check;

// How the value of a component's parameter is read.
enum class ParameterKind { kTerm, kTermList, kShape, kShapeList };

struct Component {
  const char* parameter;  // Local name in sh:, e.g. "minCount".
  const char* name;       // "MinCountConstraintComponent"
  ParameterKind kind;
  void (*check)(const Check& check);
};

// One constraint of a shape. Shapes among `terms` are in the shape graph.
struct Constraint {
  const Component* component = nullptr;
  std::vector<Term> terms;  // The parameter's value, or its list's members.
  std::string flags;        // Of sh:pattern.
};

struct Shape {
  Term id;
  Term named;  // `id` if it is an IRI, else the nearest one around it.
  bool has_path = false;  // A property shape;
  Term path;              // its path, one predicate.
  std::vector<Term> target_classes;
  std::vector<Term> target_nodes;
  std::string message;
  std::vector<Constraint> constraints;
};

// By id, so in a stable order.
using ShapeGraph = std::map<Term, Shape>;

// All shapes with a target and those they refer to. Throws InputError for a
// component or a path that is not available.
ShapeGraph LoadShapes(const GraphView& view);

// The row of the table whose parameter is sh:`local`, or null.
const Component* FindComponent(std::string_view local);

}  // namespace kg_core::shacl

#endif  // KG_CORE_MISSION_SHACL_SHAPES_H_
