// SHACL tests: compares validation reports result by result.

#include <algorithm>
#include <set>

#include "kg_base/common/input_error.h"
#include "kg_base/common/join_strings.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_core/rdf/turtle.h"
#include "kg_core/shacl/shapes.h"
#include "kg_core/shacl/validation.h"
#include "kg_engine/conformance/test_case.h"

namespace kg_engine::conformance {
namespace {

using kg_core::GraphView;
using kg_core::Iri;
using kg_core::Term;
using kg_core::ToTurtle;
using kg_core::Violation;

using kg_base::InputError;

Term Sht(const char* local) { return Iri(std::string(kSht) + local); }
Term Sh(const char* local) { return Iri(std::string(kg_core::kSh) + local); }

using Lines = std::multiset<std::string>;

std::string Line(const std::vector<std::string>& parts) {
  return kg_base::JoinStrings(parts, " | ", [](const std::string& part) {
    return part.empty() ? "-" : part;
  });
}

Lines FormatLines(const std::vector<Violation>& violations) {
  Lines lines;
  for (const Violation& v : violations) {
    lines.insert(Line({ToTurtle(v.focus_node),
                       v.path ? kg_core::shacl::ToTurtle(*v.path) : "",
                       v.has_value() ? ToTurtle(v.value) : "", v.component,
                       ToTurtle(v.severity), ToTurtle(v.source_shape)}));
  }
  return lines;
}

std::string Shown(const GraphView& view, const std::string& graph,
                  const Term& result, const char* property) {
  const auto term = kg_core::FirstObject(view, graph, result, Sh(property));
  return term ? ToTurtle(*term) : "";
}

// Formats the results of the report at `report`.
Lines FormatLines(const GraphView& view, const std::string& graph,
                  const Term& report) {
  Lines lines;
  for (const Term& result :
       kg_core::Objects(view, graph, report, Sh("result"))) {
    const auto path =
        kg_core::FirstObject(view, graph, result, Sh("resultPath"));
    lines.insert(Line({Shown(view, graph, result, "focusNode"),
                       path ? kg_core::shacl::ToTurtle(
                                  kg_core::shacl::ReadPath(view, graph, *path))
                            : "",
                       Shown(view, graph, result, "value"),
                       Shown(view, graph, result, "sourceConstraintComponent"),
                       Shown(view, graph, result, "resultSeverity"),
                       Shown(view, graph, result, "sourceShape")}));
  }
  return lines;
}

// Removes blank node labels, which change in a write-read cycle.
Lines WithoutLabels(const Lines& lines) {
  Lines without;
  for (const std::string& line : lines) {
    std::string text;
    for (std::size_t at = 0; at < line.size(); ++at) {
      text += line[at];
      if (line.compare(at, 2, "_:") != 0) continue;
      at = std::min(line.find(' ', at), line.size()) - 1;
    }
    without.insert(text);
  }
  return without;
}

// Parses a Turtle report and formats its results.
Lines LinesOfReport(const std::string& turtle) {
  const std::string graph = "urn:kg:report";
  kg_core::Store store("");
  kg_core::Transaction change = store.Begin();
  for (const kg_core::Statement& s :
       kg_core::ParseTurtle(turtle, "report", Iri(graph))) {
    change.Add(s);
  }
  const auto reports = kg_core::Subjects(
      change.view(), graph, Iri(std::string(kg_core::kRdf) + "type"),
      Sh("ValidationReport"));
  if (reports.size() != 1) throw InputError("expected one report");
  return FormatLines(change.view(), graph, reports[0]);
}

std::string Difference(const Lines& got, const Lines& want) {
  if (got == want) return "";
  const std::string sizes = "got " + std::to_string(got.size()) +
                            " results, expected " + std::to_string(want.size());
  for (const std::string& line : want) {
    if (got.count(line) < want.count(line)) return sizes + "; lacks " + line;
  }
  for (const std::string& line : got) {
    if (want.count(line) < got.count(line)) return sizes + "; has " + line;
  }
  return sizes;
}

// The first expected message that is missing, or ""; extra messages are
// allowed.
std::string LackingMessage(const TestCase& test, const Term& report,
                           const std::vector<Violation>& found) {
  std::set<Term> messages;
  for (const Violation& violation : found) {
    messages.insert(violation.messages.begin(), violation.messages.end());
  }
  for (const Term& result : test.All(report, Sh("result").text)) {
    for (const Term& message : test.All(result, Sh("resultMessage").text)) {
      if (messages.count(message) == 0) return "lacks " + ToTurtle(message);
    }
  }
  return "";
}

// Throws NotRun for SHACL-SPARQL and SHACL-JS, which are not part of SHACL
// Core.
void RefuseOtherThanCore(const GraphView& view, const std::string& shapes) {
  for (const char* property :
       {"sparql", "select", "ask", "construct", "js", "jsFunctionName",
        "validator", "nodeValidator", "propertyValidator"}) {
    kg_core::Quad pattern;
    pattern.graph = view.Find(Iri(shapes));
    pattern.predicate = view.Find(Sh(property));
    if (pattern.predicate == kg_core::kNoTerm ||
        pattern.graph == kg_core::kNoTerm) {
      continue;
    }
    if (view.Estimate(pattern) > 0) {
      throw NotRun(std::string("needs sh:") + property +
                   ", which is not in SHACL Core");
    }
  }
}

}  // namespace

std::string RunShaclTest(const TestCase& test) {
  const Term action = test.Action();
  const Term result = test.Result();
  const auto data_url = test.One(action, Sht("dataGraph").text);
  const auto shapes_url = test.One(action, Sht("shapesGraph").text);
  if (!data_url || !shapes_url) {
    throw InputError("the action lacks sht:dataGraph or sht:shapesGraph");
  }
  test.documents->Load(data_url->text);
  test.documents->Load(shapes_url->text);
  const GraphView& view = test.documents->view();
  RefuseOtherThanCore(view, shapes_url->text);
  std::vector<Violation> found;
  try {
    const auto shapes = kg_core::shacl::LoadShapes(view, shapes_url->text);
    const kg_core::shacl::DataGraph data{
        view, data_url->text, {data_url->text}, nullptr};
    found = kg_core::shacl::ShapeValidation(data, shapes).Run();
  } catch (const InputError&) {
    if (result == Sht("Failure")) return "";
    throw;
  }
  if (result == Sht("Failure")) {
    return "validated, but the shapes are ill-formed";
  }
  const auto conforms = test.One(result, Sh("conforms").text);
  if (conforms && (conforms->text == "true") != found.empty()) {
    return "sh:conforms is to be " + conforms->text;
  }
  const Lines want = FormatLines(view, test.manifest, result);
  std::string difference = Difference(FormatLines(found), want);
  if (difference.empty()) {
    difference =
        Difference(WithoutLabels(LinesOfReport(kg_core::ReportTurtle(found))),
                   WithoutLabels(want));
  }
  return difference.empty() ? LackingMessage(test, result, found) : difference;
}

}  // namespace kg_engine::conformance
