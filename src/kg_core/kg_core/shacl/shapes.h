// Loads and checks the shapes of a graph. https://www.w3.org/TR/shacl/#shapes
//
// An ill-formed shape, a recursive shape and an unknown component are rejected,
// so that nothing is silently left unchecked.

#ifndef KG_CORE_SHACL_SHAPES_H_
#define KG_CORE_SHACL_SHAPES_H_

#include <string>

#include "kg_core/rdf/graph_view.h"
#include "kg_core/shacl/shape.h"

namespace kg_core::shacl {

// All shapes with a type or a target, and the shapes they refer to. Throws
// InputError "shape ex:S: ...".
ShapeGraph LoadShapes(const GraphView& view, const std::string& graph);

}  // namespace kg_core::shacl

#endif  // KG_CORE_SHACL_SHAPES_H_
