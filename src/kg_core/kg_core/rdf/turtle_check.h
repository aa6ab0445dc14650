// Checks of a text before it is passed to serd: size, NUL, UTF-8, nesting (serd
// 0.30 recurses per bracket and crashes on 50,000), and the lines of N-Triples
// and N-Quads, where serd would also read Turtle.

#ifndef KG_CORE_RDF_TURTLE_CHECK_H_
#define KG_CORE_RDF_TURTLE_CHECK_H_

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "kg_core/rdf/syntax.h"
#include "kg_core/rdf/turtle.h"

namespace kg_core {

// The position prefix "source:line:column: " of a byte offset.
std::string TurtleErrorPlace(std::string_view text, const std::string& source,
                             std::size_t offset);

// A byte that serd is to read before the byte of the text at `offset`.
struct InsertedByte {
  std::size_t offset;
  char byte;
};

// Throws InputError "source:line:column: what was expected". Returns what serd
// 0.30 needs to read the text as it is meant, in order:
// - a 'u' before each blank node label, since serd names nodes without a label
//   b1, b2, ..., which would collide with _:b1 in the text;
// - a space between an integer and the point that ends its statement, since
//   serd takes "2." for a decimal and then drops the datatype.
std::vector<InsertedByte> CheckRdfText(std::string_view text, RdfSyntax syntax,
                                       const std::string& source,
                                       const TurtleLimits& limits);

}  // namespace kg_core

#endif  // KG_CORE_RDF_TURTLE_CHECK_H_
