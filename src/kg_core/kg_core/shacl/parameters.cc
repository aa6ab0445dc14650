#include "kg_core/shacl/parameters.h"

#include <optional>
#include <string_view>

#include "kg_base/common/input_error.h"
#include "kg_base/text/regex.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_core/sparql/values.h"

namespace kg_core::shacl {
namespace {

constexpr double kMaxCount = 1e15;  // Exact as a double.

[[noreturn]] void Expected(const Shape& shape, const std::string& local,
                           const std::string& what, const Term& value) {
  RefuseShape(shape, "expected " + what + " as sh:" + local + ", not " +
                         kg_core::ToTurtle(value));
}

bool IsNodeKind(const Term& term) {
  for (const char* kind : {"IRI", "BlankNode", "Literal", "BlankNodeOrIRI",
                           "BlankNodeOrLiteral", "IRIOrLiteral"}) {
    if (term == Iri(std::string(kSh) + kind)) return true;
  }
  return false;
}

bool IsPattern(const Term& term, const std::string& flags) {
  kg_base::RegexCache regexes;
  return sparql::IsString(term) &&
         regexes.Matches("", term.text, flags).has_value();
}

// Describes what term the constraint expects; nullopt if the given one is
// valid.
std::optional<std::string> WhatIsWrong(const Constraint& constraint,
                                       const Term& term) {
  const auto unless = [](bool good, const char* what) {
    return good ? std::nullopt : std::optional<std::string>(what);
  };
  switch (constraint.component->kind) {
    case ParameterKind::kIri:
      return unless(term.is_iri(), "an IRI");
    case ParameterKind::kNodeKind:
      return unless(IsNodeKind(term),
                    "sh:IRI, sh:BlankNode, sh:Literal or two");
    case ParameterKind::kLiteral:
      return unless(term.is_literal(), "a literal");
    case ParameterKind::kPattern:
      return unless(IsPattern(term, constraint.flags),
                    "a regular expression with flags of \"smixq\"");
    case ParameterKind::kLanguages:
      return unless(sparql::IsString(term), "language ranges");
    case ParameterKind::kShape:
    case ParameterKind::kPropertyShape:
    case ParameterKind::kShapeList:
      return unless(!term.is_literal(), "a shape");
    // Checked where they are read, or unrestricted.
    case ParameterKind::kAny:
    case ParameterKind::kTrue:
    case ParameterKind::kCount:
    case ParameterKind::kList:
    case ParameterKind::kQualified:
      return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

void RefuseShape(const Shape& shape, const std::string& what) {
  std::string line = "shape " + kg_core::ToTurtle(shape.named);
  if (shape.path) line += " at " + ToTurtle(*shape.path);
  throw kg_base::InputError(line + ": " + what);
}

bool ReadBoolean(const Shape& shape, const std::string& local,
                 const Term& value) {
  const bool is_boolean =
      value.is_literal() && value.datatype == kXsd + std::string("boolean");
  if (is_boolean && value.text == "true") return true;
  for (const char* other : {"false", "0", "1"}) {
    if (is_boolean && value.text == other) return false;
  }
  Expected(shape, local, "true or false", value);
}

std::size_t ReadCount(const Shape& shape, const std::string& local,
                      const Term& value) {
  const auto number = sparql::ToNumber(value);
  const bool is_count =
      number && number->type == sparql::XsdNumber::Type::kInteger &&
      number->ToDouble() >= 0 && number->ToDouble() <= kMaxCount;
  if (!is_count) Expected(shape, local, "an integer of at least 0", value);
  return static_cast<std::size_t>(number->ToDouble());
}

void CheckParameter(const Shape& shape, const Constraint& constraint) {
  for (const Term& term : constraint.terms) {
    const auto wrong = WhatIsWrong(constraint, term);
    if (wrong) Expected(shape, constraint.component->parameter, *wrong, term);
  }
}

}  // namespace kg_core::shacl
