// Reading and writing RDF as Turtle, TriG, N-Triples and N-Quads. Parsing is
// done by serd, after size and nesting of the text have been checked.
//
//   const RdfSyntaxName* syntax = SyntaxOfPath("facts.nq");
//   for (const Statement& s : ParseRdf(text, syntax->syntax, {"facts.nq",
//   ...}))
//
// https://www.w3.org/TR/turtle/ https://www.w3.org/TR/trig/
// https://www.w3.org/TR/n-triples/ https://www.w3.org/TR/n-quads/

#ifndef KG_CORE_RDF_SYNTAX_H_
#define KG_CORE_RDF_SYNTAX_H_

#include <string>
#include <string_view>
#include <vector>

#include "kg_core/rdf/graph_view.h"
#include "kg_core/rdf/store.h"
#include "kg_core/rdf/term.h"
#include "kg_core/rdf/turtle.h"

namespace kg_core {

enum class RdfSyntax { kTurtle, kTriG, kNTriples, kNQuads };

struct RdfSyntaxName {
  RdfSyntax syntax;
  const char* name;    // "turtle", "trig", "ntriples", "nquads".
  const char* suffix;  // ".ttl", ".trig", ".nt", ".nq".
  bool has_graphs;
};
const std::vector<RdfSyntaxName>& RdfSyntaxes();

// Each returns null if there is no such syntax. Suffixes are case-insensitive.
const RdfSyntaxName* SyntaxNamed(std::string_view name);
const RdfSyntaxName* SyntaxOfPath(std::string_view path);

// Source of a text and target of its statements.
struct RdfSource {
  std::string name;    // Shown in errors: a file name, "update of operator".
  Term default_graph;  // Graph of statements outside any named graph.
  std::string base{};  // Base IRI; "": relative IRIs are rejected.
};

// Parses a whole text. In Turtle and TriG the prefixes of namespaces.h need no
// declaration. Blank nodes are renamed so that two texts never share one by
// accident; within one text a label is one node in all graphs. A graph may be
// a blank node in TriG and N-Quads. Throws InputError
// "name:line:column: what was expected".
std::vector<Statement> ParseRdf(std::string_view text, RdfSyntax syntax,
                                const RdfSource& source,
                                const TurtleLimits& limits = {});

// Parses a file; the syntax follows from its suffix. Relative IRIs are
// rejected. Throws InputError.
std::vector<Statement> ParseRdfFile(const std::string& path,
                                    const Term& default_graph,
                                    const TurtleLimits& limits = {});

// The graphs of a view to write.
struct RdfSelection {
  // Names of graphs (ToGraphName). An empty graph writes nothing.
  std::vector<std::string> graphs;
  std::string default_graph{};  // If selected, written without its name.
};

// Writes the selected graphs, sorted and deterministic. Turtle and N-Triples
// have no graphs: there all are merged.
std::string WriteRdf(const GraphView& view, const RdfSelection& selection,
                     RdfSyntax syntax);

// Names of the graphs of `view` that hold statements (ToGraphName), sorted.
std::vector<std::string> ListGraphs(const GraphView& view);

}  // namespace kg_core

#endif  // KG_CORE_RDF_SYNTAX_H_
