// The table of constraint components.
// https://www.w3.org/TR/shacl/#core-components

#ifndef KG_CORE_SHACL_COMPONENTS_H_
#define KG_CORE_SHACL_COMPONENTS_H_

#include <string_view>

#include "kg_core/shacl/shape.h"

namespace kg_core::shacl {

// The table row with the parameter sh:`local`, or null.
const ConstraintComponent* FindComponent(std::string_view local);

}  // namespace kg_core::shacl

#endif  // KG_CORE_SHACL_COMPONENTS_H_
