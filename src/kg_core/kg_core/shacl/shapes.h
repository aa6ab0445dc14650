// The shapes of a graph, read and checked once.
// https://www.w3.org/TR/shacl/#shapes
//
// An ill-formed shape, a shape that refers to itself and a component that is
// not known are refused: nothing is silently unchecked.

#ifndef KG_CORE_SHACL_SHAPES_H_
#define KG_CORE_SHACL_SHAPES_H_

#include <string>

#include "kg_core/rdf/graph_view.h"
#include "kg_core/shacl/shape.h"

namespace kg_core::shacl {

// All shapes with a type or a target and those they refer to. Throws InputError
// "shape ex:S: ...".
ShapeGraph LoadShapes(const GraphView& view, const std::string& graph);

}  // namespace kg_core::shacl

#endif  // KG_CORE_SHACL_SHAPES_H_
