#include "kg_core/shacl/violation.h"

#include "kg_core/rdf/namespaces.h"

namespace kg_core {
namespace {

std::string ResultTurtle(const Violation& violation) {
  std::string text = "  sh:result [ a sh:ValidationResult";
  const auto add = [&](const char* property, const std::string& value) {
    text += std::string(" ;\n    sh:") + property + " " + value;
  };
  add("focusNode", ToTurtle(violation.focus_node));
  if (violation.path) add("resultPath", shacl::ToTurtle(*violation.path));
  if (violation.has_value()) add("value", ToTurtle(violation.value));
  add("resultSeverity", ToTurtle(violation.severity));
  add("sourceConstraintComponent", violation.component);
  add("sourceShape", ToTurtle(violation.source_shape));
  for (const Term& message : violation.messages) {
    add("resultMessage", ToTurtle(message));
  }
  return text + " ]";
}

}  // namespace

std::string Violation::Line() const {
  std::string line = ToTurtle(focus_node);
  if (path) line += " " + shacl::ToTurtle(*path);
  line += ": " + message;
  if (has_value() && value != focus_node) line += ", not " + ToTurtle(value);
  return line + " (" + ToTurtle(named_shape) + ")";
}

std::vector<std::string> Lines(const std::vector<Violation>& violations) {
  std::vector<std::string> lines;
  for (const Violation& violation : violations) {
    lines.push_back(violation.Line());
  }
  return lines;
}

std::string ReportTurtle(const std::vector<Violation>& violations) {
  std::string text;
  for (const NamespacePrefix& prefix : kPrefixes) {
    text +=
        std::string("@prefix ") + prefix.name + ": <" + prefix.iri + "> .\n";
  }
  text += "\n[] a sh:ValidationReport ;\n  sh:conforms ";
  text += violations.empty() ? "true" : "false";
  for (const Violation& violation : violations) {
    text += " ;\n" + ResultTurtle(violation);
  }
  return text + " .\n";
}

}  // namespace kg_core
