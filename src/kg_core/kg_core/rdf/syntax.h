// The syntaxes of RDF in and out, by serd: Turtle, TriG, N-Triples and N-Quads,
// with caps on size and nesting before serd sees the text.
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
  const char* name;        // "turtle", "trig", "ntriples", "nquads".
  const char* suffix;      // ".ttl", ".trig", ".nt", ".nq".
  const char* media_type;  // RFC 6838
  bool has_graphs;
};
const std::vector<RdfSyntaxName>& RdfSyntaxes();

// All null if there is none such. Suffixes and media types in any case; what
// follows a media type (";charset=utf-8") is not looked at.
const RdfSyntaxName* SyntaxNamed(std::string_view name);
const RdfSyntaxName* SyntaxOfPath(std::string_view path);
const RdfSyntaxName* SyntaxOfMediaType(std::string_view media_type);

// Where a text comes from and goes to.
struct RdfSource {
  std::string name;    // Stands in errors: a file name, "update of operator".
  Term default_graph;  // Of statements that the text puts into no graph.
  std::string base{};  // What relative IRIs are relative to; "": refused.
};

// Reads a whole text. Turtle and TriG know our prefixes undeclared. Blank nodes
// are renamed so that two texts never share one by accident; within one text a
// label is one node in all graphs. Graphs may be blank nodes in TriG and
// N-Quads, which a store refuses. Throws InputError
// "name:line:column: what was expected".
std::vector<Statement> ParseRdf(std::string_view text, RdfSyntax syntax,
                                const RdfSource& source,
                                const TurtleLimits& limits = {});

// A file by its suffix, relative IRIs refused. Throws InputError.
std::vector<Statement> ParseRdfFile(const std::string& path,
                                    const Term& default_graph,
                                    const TurtleLimits& limits = {});

// What to write of a view.
struct RdfSelection {
  std::vector<std::string> graphs;  // IRIs. One that is empty writes nothing.
  std::string default_graph{};      // Written without its name, if chosen.
};

// The chosen graphs, sorted, the same every time. Turtle and N-Triples have no
// graphs: there all are merged.
std::string WriteRdf(const GraphView& view, const RdfSelection& selection,
                     RdfSyntax syntax);

// The graphs of `view` that hold statements, sorted.
std::vector<std::string> ListGraphs(const GraphView& view);

}  // namespace kg_core

#endif  // KG_CORE_RDF_SYNTAX_H_
