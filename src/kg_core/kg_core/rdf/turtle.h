// Reading and writing Turtle. Parsing is done by serd, after size and nesting
// of the text have been checked (serd 0.30 crashes on 50,000 nested lists).

#ifndef KG_CORE_RDF_TURTLE_H_
#define KG_CORE_RDF_TURTLE_H_

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "kg_core/rdf/graph_view.h"
#include "kg_core/rdf/store.h"
#include "kg_core/rdf/term.h"

namespace kg_core {

struct TurtleLimits {
  std::size_t bytes = 64u << 20;
  int nesting = 200;
};

// Parses Turtle into `graph`; the prefixes of namespaces.h need no declaration.
// Blank node labels are renamed so that two texts never share one by accident.
// `source` (a file name, "update of operator") is named in errors. Throws
// InputError "source:line:column: what was expected".
std::vector<Statement> ParseTurtle(std::string_view text,
                                   const std::string& source, const Term& graph,
                                   const TurtleLimits& limits = {});
std::vector<Statement> ParseTurtleFile(const std::string& path,
                                       const Term& graph,
                                       const TurtleLimits& limits = {});

// One term in Turtle's term syntax ("ex:alpha", "<iri>", "\"x\"@en", "0.4",
// "3", "true", "\"POINT(1 2)\"^^geo:wktLiteral"); throws InputError.
Term ParseTurtleTerm(std::string_view text);

// Writes all statements of `graph`, sorted, with the prefixes of namespaces.h.
std::string WriteTurtle(const GraphView& view, std::string_view graph);

}  // namespace kg_core

#endif  // KG_CORE_RDF_TURTLE_H_
