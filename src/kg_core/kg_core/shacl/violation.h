// One result of a validation. https://www.w3.org/TR/shacl/#results

#ifndef KG_CORE_SHACL_VIOLATION_H_
#define KG_CORE_SHACL_VIOLATION_H_

#include <optional>
#include <string>
#include <vector>

#include "kg_core/rdf/term.h"
#include "kg_core/shacl/path.h"

namespace kg_core {

struct Violation {
  Term focus_node;
  std::optional<shacl::PropertyPath> path;  // nullopt for a node shape.
  Term value;                               // Empty IRI: no single value.
  Term source_shape;                        // Often a blank node.
  Term named_shape;            // Nearest enclosing shape with an IRI.
  Term severity;               // sh:Violation, sh:Warning, sh:Info or another.
  std::string component;       // "sh:MinCountConstraintComponent"
  std::string message;         // The message to show.
  std::vector<Term> messages;  // All of the shape, in any language.

  bool has_value() const { return value.is_literal() || !value.text.empty(); }
  std::string Line() const;  // "ex:alpha ex:usesPolicy: ... (shape ...)"
};

std::vector<std::string> Lines(const std::vector<Violation>& violations);

// A W3C validation report in Turtle, with the prefixes that it needs.
// https://www.w3.org/TR/shacl/#validation-report
std::string ReportTurtle(const std::vector<Violation>& violations);

}  // namespace kg_core

#endif  // KG_CORE_SHACL_VIOLATION_H_
