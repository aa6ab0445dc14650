#include "kg_core/mission/shacl_components.h"

#include <algorithm>
#include <optional>
#include <string>

#include "kg_core/base/input_error.h"
#include "kg_core/mission/literals.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_core/sparql/utf8.h"
#include "kg_core/sparql/values.h"

namespace kg_core::shacl {
namespace {

// A component that asks the same of each value node.
template <bool (*Holds)(const Check&, const Term&)>
void EachValue(const Check& check) {
  for (const Term& value : check.values) {
    if (!Holds(check, value)) check.Report(value);
  }
}

double NumberOf(const Check& check) {
  const std::optional<double> number = NumericValue(check.parameter());
  if (number) return *number;
  throw InputError("shape " + ToTurtle(check.shape.named) + ": sh:" +
                   check.constraint.component->parameter + " must be a number");
}

// https://www.w3.org/TR/shacl/#ClassConstraintComponent
bool IsOfClass(const Check& check, const Term& value) {
  return !value.is_literal() && check.run.IsInstance(value, check.parameter());
}

// https://www.w3.org/TR/shacl/#DatatypeConstraintComponent
bool HasDatatype(const Check& check, const Term& value) {
  return value.is_literal() && value.datatype == check.parameter().text &&
         IsWellFormed(value);
}

// https://www.w3.org/TR/shacl/#NodeKindConstraintComponent
bool HasNodeKind(const Check& check, const Term& value) {
  const std::string kind = check.parameter().text.substr(sizeof(kSh) - 1);
  const char* name = value.is_iri()     ? "IRI"
                     : value.is_blank() ? "BlankNode"
                                        : "Literal";
  return kind.find(name) != std::string::npos;
}

// https://www.w3.org/TR/shacl/#MinCountConstraintComponent
void CheckMinCount(const Check& check) {
  const auto count = static_cast<double>(check.values.size());
  if (!(count >= NumberOf(check))) check.Report({});
}

// https://www.w3.org/TR/shacl/#MaxCountConstraintComponent
void CheckMaxCount(const Check& check) {
  const auto count = static_cast<double>(check.values.size());
  if (!(count <= NumberOf(check))) check.Report({});
}

// https://www.w3.org/TR/shacl/#core-components-range: what cannot be compared
// (NaN, a string with a number) violates.
std::optional<sparql::Order> OrderOf(const Term& a, const Term& b) {
  if (!a.is_literal() || !b.is_literal()) return std::nullopt;
  return sparql::Compare(a, b);
}
bool IsLess(const Term& a, const Term& b) {
  return OrderOf(a, b) == sparql::Order::kLess;
}
bool IsLessOrEqual(const Term& a, const Term& b) {
  return IsLess(a, b) || OrderOf(a, b) == sparql::Order::kEqual;
}
bool IsAbove(const Check& check, const Term& value) {
  return IsLess(check.parameter(), value);
}
bool IsAtLeast(const Check& check, const Term& value) {
  return IsLessOrEqual(check.parameter(), value);
}
bool IsBelow(const Check& check, const Term& value) {
  return IsLess(value, check.parameter());
}
bool IsAtMost(const Check& check, const Term& value) {
  return IsLessOrEqual(value, check.parameter());
}

// https://www.w3.org/TR/shacl/#core-components-string
double Length(const Term& value) {
  return static_cast<double>(sparql::Utf8Length(value.text));
}
bool IsLongEnough(const Check& check, const Term& value) {
  return !value.is_blank() && Length(value) >= NumberOf(check);
}
bool IsShortEnough(const Check& check, const Term& value) {
  return !value.is_blank() && Length(value) <= NumberOf(check);
}
bool MatchesPattern(const Check& check, const Term& value) {
  if (value.is_blank()) return false;
  const std::string& pattern = check.parameter().text;
  const auto matches =
      check.run.regexes().Matches(value.text, pattern, check.constraint.flags);
  if (matches) return *matches;
  throw InputError("shape " + ToTurtle(check.shape.named) + ": sh:pattern \"" +
                   pattern + "\" is not a regular expression");
}

// https://www.w3.org/TR/shacl/#InConstraintComponent
bool IsIn(const Check& check, const Term& value) {
  const std::vector<Term>& allowed = check.constraint.terms;
  return std::find(allowed.begin(), allowed.end(), value) != allowed.end();
}

// https://www.w3.org/TR/shacl/#HasValueConstraintComponent
void CheckHasValue(const Check& check) {
  const std::vector<Term>& values = check.values;
  if (std::find(values.begin(), values.end(), check.parameter()) ==
      values.end()) {
    check.Report({});
  }
}

// https://www.w3.org/TR/shacl/#core-components-property-pairs
template <bool (*Holds)(const Term&, const Term&)>
void CheckPair(const Check& check) {
  const std::vector<Term> others =
      Objects(check.run.view(), kFactsGraph, check.focus, check.parameter());
  for (const Term& value : check.values) {
    for (const Term& other : others) {
      if (!Holds(value, other)) check.Report(value);
    }
  }
}

// https://www.w3.org/TR/shacl/#NodeConstraintComponent
bool ConformsToNode(const Check& check, const Term& value) {
  return check.run.Conforms(check.parameter(), value);
}

// https://www.w3.org/TR/shacl/#PropertyConstraintComponent
void CheckProperty(const Check& check) {
  const Shape& property = check.run.shape(check.parameter());
  for (const Term& value : check.values) {
    check.run.CheckShape(property, value, check.found);
  }
}

// https://www.w3.org/TR/shacl/#core-components-logical
std::ptrdiff_t CountConforming(const Check& check, const Term& value) {
  const std::vector<Term>& shapes = check.constraint.terms;
  return std::count_if(shapes.begin(), shapes.end(), [&](const Term& shape) {
    return check.run.Conforms(shape, value);
  });
}
bool ConformsToAny(const Check& check, const Term& value) {
  return CountConforming(check, value) >= 1;
}
bool ConformsToOne(const Check& check, const Term& value) {
  return CountConforming(check, value) == 1;
}
bool ConformsToAll(const Check& check, const Term& value) {
  return CountConforming(check, value) ==
         static_cast<std::ptrdiff_t>(check.constraint.terms.size());
}
bool ConformsToNone(const Check& check, const Term& value) {
  return CountConforming(check, value) == 0;
}

using Kind = ParameterKind;
constexpr Component kComponents[] = {
    {"minCount", "MinCountConstraintComponent", Kind::kTerm, CheckMinCount},
    {"maxCount", "MaxCountConstraintComponent", Kind::kTerm, CheckMaxCount},
    {"class", "ClassConstraintComponent", Kind::kTerm, EachValue<IsOfClass>},
    {"datatype", "DatatypeConstraintComponent", Kind::kTerm,
     EachValue<HasDatatype>},
    {"nodeKind", "NodeKindConstraintComponent", Kind::kTerm,
     EachValue<HasNodeKind>},
    {"minExclusive", "MinExclusiveConstraintComponent", Kind::kTerm,
     EachValue<IsAbove>},
    {"minInclusive", "MinInclusiveConstraintComponent", Kind::kTerm,
     EachValue<IsAtLeast>},
    {"maxExclusive", "MaxExclusiveConstraintComponent", Kind::kTerm,
     EachValue<IsBelow>},
    {"maxInclusive", "MaxInclusiveConstraintComponent", Kind::kTerm,
     EachValue<IsAtMost>},
    {"minLength", "MinLengthConstraintComponent", Kind::kTerm,
     EachValue<IsLongEnough>},
    {"maxLength", "MaxLengthConstraintComponent", Kind::kTerm,
     EachValue<IsShortEnough>},
    {"pattern", "PatternConstraintComponent", Kind::kTerm,
     EachValue<MatchesPattern>},
    {"in", "InConstraintComponent", Kind::kTermList, EachValue<IsIn>},
    {"hasValue", "HasValueConstraintComponent", Kind::kTerm, CheckHasValue},
    {"lessThan", "LessThanConstraintComponent", Kind::kTerm, CheckPair<IsLess>},
    {"lessThanOrEquals", "LessThanOrEqualsConstraintComponent", Kind::kTerm,
     CheckPair<IsLessOrEqual>},
    {"node", "NodeConstraintComponent", Kind::kShape,
     EachValue<ConformsToNode>},
    {"property", "PropertyShapeComponent", Kind::kShape, CheckProperty},
    {"or", "OrConstraintComponent", Kind::kShapeList, EachValue<ConformsToAny>},
    {"xone", "XoneConstraintComponent", Kind::kShapeList,
     EachValue<ConformsToOne>},
    {"and", "AndConstraintComponent", Kind::kShapeList,
     EachValue<ConformsToAll>},
    {"not", "NotConstraintComponent", Kind::kShape, EachValue<ConformsToNone>},
};

}  // namespace

const Component* FindComponent(std::string_view local) {
  for (const Component& component : kComponents) {
    if (local == component.parameter) return &component;
  }
  return nullptr;
}

void Check::Report(const Term& value) const {
  Violation violation;
  violation.focus_node = focus;
  violation.path = shape.path;
  violation.value = value;
  violation.source_shape = shape.id;
  violation.named_shape = shape.named;
  violation.component = std::string("sh:") + constraint.component->name;
  violation.message = shape.message;
  if (violation.message.empty()) {
    violation.message = std::string("does not conform to sh:") +
                        constraint.component->parameter;
  }
  found.push_back(std::move(violation));
}

}  // namespace kg_core::shacl
