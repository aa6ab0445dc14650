#include "kg_core/shacl/shape.h"

namespace kg_core::shacl {

bool RefersToShapes(ParameterKind kind) {
  return kind == ParameterKind::kShape || kind == ParameterKind::kShapeList ||
         kind == ParameterKind::kPropertyShape ||
         kind == ParameterKind::kQualified;
}

}  // namespace kg_core::shacl
