// Checks of shape parameters against the kinds required by their components.
// https://www.w3.org/TR/shacl/#dfn-ill-formed

#ifndef KG_CORE_SHACL_PARAMETERS_H_
#define KG_CORE_SHACL_PARAMETERS_H_

#include <cstddef>
#include <string>

#include "kg_core/shacl/shape.h"

namespace kg_core::shacl {

// Throws InputError "shape ex:S (at ex:p): ...".
[[noreturn]] void RefuseShape(const Shape& shape, const std::string& what);

// The boolean value of sh:`local`; rejects the shape if the value is not a
// boolean. Only the term `true` is true, "1"^^xsd:boolean is not (W3C test
// property/uniqueLang-002).
bool ReadBoolean(const Shape& shape, const std::string& local,
                 const Term& value);
std::size_t ReadCount(const Shape& shape, const std::string& local,
                      const Term& value);

// Rejects the shape if the constraint's terms do not have the kind required by
// its component.
void CheckParameter(const Shape& shape, const Constraint& constraint);

}  // namespace kg_core::shacl

#endif  // KG_CORE_SHACL_PARAMETERS_H_
