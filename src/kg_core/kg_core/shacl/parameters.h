// Are the parameters of a shape what their component expects?
// https://www.w3.org/TR/shacl/#dfn-ill-formed

#ifndef KG_CORE_SHACL_PARAMETERS_H_
#define KG_CORE_SHACL_PARAMETERS_H_

#include <cstddef>
#include <string>

#include "kg_core/shacl/shape.h"

namespace kg_core::shacl {

// Throws InputError "shape ex:S (at ex:p): ...".
[[noreturn]] void RefuseShape(const Shape& shape, const std::string& what);

// The value of sh:`local`; refuses the shape if it is none. Only the term
// `true` is true, "1"^^xsd:boolean is not (W3C test property/uniqueLang-002).
bool ReadBoolean(const Shape& shape, const std::string& local,
                 const Term& value);
std::size_t ReadCount(const Shape& shape, const std::string& local,
                      const Term& value);

// Refuses the shape if the constraint's terms are not of its component's kind.
void CheckParameter(const Shape& shape, const Constraint& constraint);

}  // namespace kg_core::shacl

#endif  // KG_CORE_SHACL_PARAMETERS_H_
