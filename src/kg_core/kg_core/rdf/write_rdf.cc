// The writers declared in syntax.h and turtle.h.

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "kg_core/rdf/namespaces.h"
#include "kg_core/rdf/syntax.h"

namespace kg_core {
namespace {

// The statements about a subject: objects grouped by property, all in Turtle
// syntax.
using PropertyTexts = std::map<std::string, std::set<std::string>>;
using SubjectTexts = std::map<std::string, PropertyTexts>;

void Collect(const GraphView& view, const std::string& graph,
             SubjectTexts* subjects) {
  static const std::string kType = std::string(kRdf) + "type";
  const TermId graph_id = view.Find(GraphFromName(graph));
  if (graph_id == kNoTerm) return;
  view.Match({0, 0, 0, graph_id}, [&](const Quad& quad) {
    const Term& predicate = view.Get(quad.predicate);
    const bool is_type = predicate.is_iri() && predicate.text == kType;
    (*subjects)[ToTurtle(view.Get(quad.subject))]
               [is_type ? "a" : ToTurtle(predicate)]
                   .insert(ToTurtle(view.Get(quad.object)));
    return true;
  });
}

void Append(const SubjectTexts& subjects, std::string* out) {
  for (const auto& [subject, properties] : subjects) {
    *out += "\n" + subject;
    const char* before_property = " ";
    for (const auto& [property, objects] : properties) {
      *out += before_property + property + " ";
      before_property = " ;\n    ";
      const char* before_object = "";
      for (const std::string& object : objects) {
        *out += before_object + object;
        before_object = ", ";
      }
    }
    *out += " .\n";
  }
}

std::string OurPrefixes() {
  std::string out;
  for (const NamespacePrefix& prefix : kPrefixes) {
    out += std::string("@prefix ") + prefix.name + ": <" + prefix.iri + "> .\n";
  }
  return out;
}

std::string ToTurtleText(const GraphView& view, const RdfSelection& selection) {
  SubjectTexts subjects;
  for (const std::string& graph : selection.graphs) {
    Collect(view, graph, &subjects);
  }
  std::string out = OurPrefixes();
  Append(subjects, &out);
  return out;
}

std::string ToTriG(const GraphView& view, const RdfSelection& selection) {
  std::string out = OurPrefixes();
  const std::set<std::string> graphs(selection.graphs.begin(),
                                     selection.graphs.end());
  for (const std::string& graph : graphs) {
    SubjectTexts subjects;
    Collect(view, graph, &subjects);
    if (subjects.empty()) continue;
    const bool is_default = graph == selection.default_graph;
    if (!is_default) out += "\n" + ToTurtle(GraphFromName(graph)) + " {";
    Append(subjects, &out);
    if (!is_default) out += "}\n";
  }
  return out;
}

std::string ToLines(const GraphView& view, const RdfSelection& selection,
                    bool has_graphs) {
  std::set<std::string> lines;
  for (const std::string& graph : selection.graphs) {
    const TermId graph_id = view.Find(GraphFromName(graph));
    if (graph_id == kNoTerm) continue;
    const bool is_named = has_graphs && graph != selection.default_graph;
    const std::string end =
        is_named ? " " + ToNTriples(GraphFromName(graph)) : "";
    view.Match({0, 0, 0, graph_id}, [&](const Quad& quad) {
      lines.insert(ToNTriples(view.Get(quad.subject)) + " " +
                   ToNTriples(view.Get(quad.predicate)) + " " +
                   ToNTriples(view.Get(quad.object)) + end + " .\n");
      return true;
    });
  }
  std::string out;
  for (const std::string& line : lines) out += line;
  return out;
}

}  // namespace

std::string WriteRdf(const GraphView& view, const RdfSelection& selection,
                     RdfSyntax syntax) {
  switch (syntax) {
    case RdfSyntax::kTurtle:
      return ToTurtleText(view, selection);
    case RdfSyntax::kTriG:
      return ToTriG(view, selection);
    case RdfSyntax::kNTriples:
      return ToLines(view, selection, false);
    case RdfSyntax::kNQuads:
      return ToLines(view, selection, true);
  }
  return {};
}

std::string WriteTurtle(const GraphView& view, std::string_view graph) {
  return WriteRdf(view, {{std::string(graph)}}, RdfSyntax::kTurtle);
}

std::vector<std::string> ListGraphs(const GraphView& view) {
  std::set<TermId> ids;
  view.Match({}, [&](const Quad& quad) {
    ids.insert(quad.graph);
    return true;
  });
  std::vector<std::string> graphs;
  for (const TermId id : ids) graphs.push_back(ToGraphName(view.Get(id)));
  std::sort(graphs.begin(), graphs.end());
  return graphs;
}

}  // namespace kg_core
