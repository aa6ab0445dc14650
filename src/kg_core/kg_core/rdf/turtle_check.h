// What is checked of a Turtle text before serd sees it: size, NUL, UTF-8,
// nesting (serd 0.30 recurses per bracket and crashes on 50,000) and blank node
// labels that serd 0.30 would silently merge.

#ifndef KG_CORE_RDF_TURTLE_CHECK_H_
#define KG_CORE_RDF_TURTLE_CHECK_H_

#include <string>
#include <string_view>

#include "kg_core/rdf/turtle.h"

namespace kg_core {

// "source:line:column: " of a byte offset.
std::string TurtleErrorPlace(std::string_view text, const std::string& source,
                             std::size_t offset);

// Throws InputError "source:line:column: what was expected".
void CheckTurtleText(std::string_view text, const std::string& source,
                     const TurtleLimits& limits);

}  // namespace kg_core

#endif  // KG_CORE_RDF_TURTLE_CHECK_H_
