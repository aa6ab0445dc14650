#include "kg_core/shacl/components.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "kg_base/common/input_error.h"
#include "kg_base/text/utf8.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_core/shacl/lexical.h"
#include "kg_core/shacl/validation.h"
#include "kg_core/sparql/values.h"

namespace kg_core::shacl {
namespace {

// A component that applies the same test to each value node.
template <bool (*Fits)(const ConstraintCheck&, const Term&)>
void EachValue(const ConstraintCheck& check) {
  for (const Term& value : check.values) {
    if (!Fits(check, value)) check.Report(value);
  }
}

bool Holds(const std::vector<Term>& terms, const Term& term) {
  return std::find(terms.begin(), terms.end(), term) != terms.end();
}

// https://www.w3.org/TR/shacl/#ClassConstraintComponent
bool IsOfClass(const ConstraintCheck& check, const Term& value) {
  return !value.is_literal() && check.run.IsInstance(value, check.parameter());
}

// https://www.w3.org/TR/shacl/#DatatypeConstraintComponent
bool HasDatatype(const ConstraintCheck& check, const Term& value) {
  return value.is_literal() && value.datatype == check.parameter().text &&
         IsLexical(value, check.run.regexes());
}

// https://www.w3.org/TR/shacl/#NodeKindConstraintComponent
bool HasNodeKind(const ConstraintCheck& check, const Term& value) {
  const std::string kind = check.parameter().text.substr(sizeof(kSh) - 1);
  const char* name = value.is_iri()     ? "IRI"
                     : value.is_blank() ? "BlankNode"
                                        : "Literal";
  return kind.find(name) != std::string::npos;
}

// https://www.w3.org/TR/shacl/#MinCountConstraintComponent
void CheckMinCount(const ConstraintCheck& check) {
  if (check.values.size() < check.constraint.count) check.Report({});
}

// https://www.w3.org/TR/shacl/#MaxCountConstraintComponent
void CheckMaxCount(const ConstraintCheck& check) {
  if (check.values.size() > check.constraint.count) check.Report({});
}

// A time without a zone may be in any zone from +14:00 to -14:00.
// https://www.w3.org/TR/xmlschema11-2/#dateTime-order
bool IsDateTime(const Term& term) {
  return term.datatype == kXsd + std::string("dateTime");
}
bool HasZone(const Term& time) {
  const std::size_t clock = time.text.find('T');
  return clock != std::string::npos &&
         time.text.find_first_of("Z+-", clock) != std::string::npos;
}
Term InZone(const Term& time, const char* zone) {
  return HasZone(time) ? time : Literal(time.text + zone, time.datatype);
}

// https://www.w3.org/TR/shacl/#core-components-range: values that cannot be
// compared (NaN, a string with a number) violate the constraint.
std::optional<sparql::Order> CompareTerms(const Term& a, const Term& b) {
  if (!a.is_literal() || !b.is_literal()) return std::nullopt;
  if (!IsDateTime(a) || !IsDateTime(b) || HasZone(a) == HasZone(b)) {
    return sparql::Compare(a, b);
  }
  const auto early = sparql::Compare(InZone(a, "+14:00"), InZone(b, "+14:00"));
  const auto late = sparql::Compare(InZone(a, "-14:00"), InZone(b, "-14:00"));
  return early == late ? early : std::nullopt;
}
bool IsLess(const Term& a, const Term& b) {
  return CompareTerms(a, b) == sparql::Order::kLess;
}
bool IsLessOrEqual(const Term& a, const Term& b) {
  return IsLess(a, b) || CompareTerms(a, b) == sparql::Order::kEqual;
}
bool IsAbove(const ConstraintCheck& check, const Term& value) {
  return IsLess(check.parameter(), value);
}
bool IsAtLeast(const ConstraintCheck& check, const Term& value) {
  return IsLessOrEqual(check.parameter(), value);
}
bool IsBelow(const ConstraintCheck& check, const Term& value) {
  return IsLess(value, check.parameter());
}
bool IsAtMost(const ConstraintCheck& check, const Term& value) {
  return IsLessOrEqual(value, check.parameter());
}

// https://www.w3.org/TR/shacl/#core-components-string
bool IsLongEnough(const ConstraintCheck& check, const Term& value) {
  return !value.is_blank() &&
         kg_base::Utf8Length(value.text) >= check.constraint.count;
}
bool IsShortEnough(const ConstraintCheck& check, const Term& value) {
  return !value.is_blank() &&
         kg_base::Utf8Length(value.text) <= check.constraint.count;
}
bool MatchesPattern(const ConstraintCheck& check, const Term& value) {
  if (value.is_blank()) return false;
  const std::string& pattern = check.parameter().text;
  return check.run.regexes()
      .Matches(value.text, pattern, check.constraint.flags)
      .value_or(false);
}

// https://www.w3.org/TR/shacl/#LanguageInConstraintComponent "de" matches "de"
// and "de-CH". https://tools.ietf.org/html/rfc4647#section-3.3.1
bool HasLanguage(const ConstraintCheck& check, const Term& value) {
  const std::vector<Term>& ranges = check.constraint.terms;
  return std::any_of(ranges.begin(), ranges.end(), [&](const Term& term) {
    if (value.language.empty()) return false;
    const std::string tag = kg_base::LowerCase(value.language);
    const std::string range = kg_base::LowerCase(term.text);
    return range == "*" || tag == range || tag.rfind(range + "-", 0) == 0;
  });
}

// https://www.w3.org/TR/shacl/#UniqueLangConstraintComponent
void CheckUniqueLang(const ConstraintCheck& check) {
  std::map<std::string, int> counts;
  for (const Term& value : check.values) {
    if (!value.language.empty()) ++counts[kg_base::LowerCase(value.language)];
  }
  for (const auto& [language, count] : counts) {
    if (count > 1) check.Report({});
  }
}

// https://www.w3.org/TR/shacl/#InConstraintComponent
bool IsIn(const ConstraintCheck& check, const Term& value) {
  return Holds(check.constraint.terms, value);
}

// https://www.w3.org/TR/shacl/#HasValueConstraintComponent
void CheckHasValue(const ConstraintCheck& check) {
  if (!Holds(check.values, check.parameter())) check.Report({});
}

// https://www.w3.org/TR/shacl/#ClosedConstraintComponent
void CheckClosed(const ConstraintCheck& check) {
  const DataGraph& data = check.run.data();
  for (const Term& value : check.values) {
    Quad pattern;
    pattern.subject = data.view.Find(value);
    pattern.graph = data.view.Find(Iri(data.graph));
    if (pattern.subject == kNoTerm || pattern.graph == kNoTerm) continue;
    data.view.Match(pattern, [&](const Quad& quad) {
      const Term& predicate = data.view.Get(quad.predicate);
      if (Holds(check.constraint.others, predicate)) return true;
      check.Report(data.view.Get(quad.object)).path = PredicatePath(predicate);
      return true;
    });
  }
}

// https://www.w3.org/TR/shacl/#core-components-property-pairs
std::vector<Term> OtherValues(const ConstraintCheck& check) {
  return Step(check.run.data(), check.focus, check.parameter(),
              Direction::kForward);
}
template <bool (*Fits)(const Term&, const Term&)>
void CheckPair(const ConstraintCheck& check) {
  const std::vector<Term> others = OtherValues(check);
  for (const Term& value : check.values) {
    for (const Term& other : others) {
      if (!Fits(value, other)) check.Report(value);
    }
  }
}
void CheckEquals(const ConstraintCheck& check) {
  const std::vector<Term> others = OtherValues(check);
  for (const Term& value : check.values) {
    if (!Holds(others, value)) check.Report(value);
  }
  for (const Term& other : others) {
    if (!Holds(check.values, other)) check.Report(other);
  }
}
void CheckDisjoint(const ConstraintCheck& check) {
  const std::vector<Term> others = OtherValues(check);
  for (const Term& value : check.values) {
    if (Holds(others, value)) check.Report(value);
  }
}

// https://www.w3.org/TR/shacl/#NodeConstraintComponent
bool ConformsToNode(const ConstraintCheck& check, const Term& value) {
  return check.run.Conforms(check.parameter(), value);
}

// https://www.w3.org/TR/shacl/#PropertyConstraintComponent
void CheckProperty(const ConstraintCheck& check) {
  const Shape& property = check.run.shape(check.parameter());
  for (const Term& value : check.values) {
    check.run.CheckShape(property, value, check.found);
  }
}

// https://www.w3.org/TR/shacl/#core-components-logical
std::ptrdiff_t CountConforming(const ConstraintCheck& check,
                               const Term& value) {
  const std::vector<Term>& shapes = check.constraint.terms;
  return std::count_if(shapes.begin(), shapes.end(), [&](const Term& shape) {
    return check.run.Conforms(shape, value);
  });
}
bool ConformsToAny(const ConstraintCheck& check, const Term& value) {
  return CountConforming(check, value) >= 1;
}
bool ConformsToOne(const ConstraintCheck& check, const Term& value) {
  return CountConforming(check, value) == 1;
}
bool ConformsToAll(const ConstraintCheck& check, const Term& value) {
  return CountConforming(check, value) ==
         static_cast<std::ptrdiff_t>(check.constraint.terms.size());
}
bool ConformsToNone(const ConstraintCheck& check, const Term& value) {
  return CountConforming(check, value) == 0;
}

// https://www.w3.org/TR/shacl/#QualifiedValueShapeConstraintComponent
std::size_t CountQualified(const ConstraintCheck& check) {
  const std::vector<Term>& siblings = check.constraint.others;
  const auto count = std::count_if(
      check.values.begin(), check.values.end(), [&](const Term& value) {
        return check.run.Conforms(check.parameter(), value) &&
               std::none_of(siblings.begin(), siblings.end(),
                            [&](const Term& sibling) {
                              return check.run.Conforms(sibling, value);
                            });
      });
  return static_cast<std::size_t>(count);
}
void CheckQualifiedMin(const ConstraintCheck& check) {
  if (CountQualified(check) < check.constraint.count) check.Report({});
}
void CheckQualifiedMax(const ConstraintCheck& check) {
  if (CountQualified(check) > check.constraint.count) check.Report({});
}

constexpr bool kMaxOne = true;
constexpr bool kPropertyOnly = true;
constexpr ConstraintComponent kComponents[] = {
    {"minCount", "MinCountConstraintComponent", ParameterKind::kCount,
     CheckMinCount, kMaxOne, kPropertyOnly},
    {"maxCount", "MaxCountConstraintComponent", ParameterKind::kCount,
     CheckMaxCount, kMaxOne, kPropertyOnly},
    {"class", "ClassConstraintComponent", ParameterKind::kIri,
     EachValue<IsOfClass>},
    {"datatype", "DatatypeConstraintComponent", ParameterKind::kIri,
     EachValue<HasDatatype>, kMaxOne},
    {"nodeKind", "NodeKindConstraintComponent", ParameterKind::kNodeKind,
     EachValue<HasNodeKind>, kMaxOne},
    {"minExclusive", "MinExclusiveConstraintComponent", ParameterKind::kLiteral,
     EachValue<IsAbove>, kMaxOne},
    {"minInclusive", "MinInclusiveConstraintComponent", ParameterKind::kLiteral,
     EachValue<IsAtLeast>, kMaxOne},
    {"maxExclusive", "MaxExclusiveConstraintComponent", ParameterKind::kLiteral,
     EachValue<IsBelow>, kMaxOne},
    {"maxInclusive", "MaxInclusiveConstraintComponent", ParameterKind::kLiteral,
     EachValue<IsAtMost>, kMaxOne},
    {"minLength", "MinLengthConstraintComponent", ParameterKind::kCount,
     EachValue<IsLongEnough>, kMaxOne},
    {"maxLength", "MaxLengthConstraintComponent", ParameterKind::kCount,
     EachValue<IsShortEnough>, kMaxOne},
    {"pattern", "PatternConstraintComponent", ParameterKind::kPattern,
     EachValue<MatchesPattern>, kMaxOne},
    {"languageIn", "LanguageInConstraintComponent", ParameterKind::kLanguages,
     EachValue<HasLanguage>, kMaxOne},
    {"uniqueLang", "UniqueLangConstraintComponent", ParameterKind::kTrue,
     CheckUniqueLang, kMaxOne, kPropertyOnly},
    {"in", "InConstraintComponent", ParameterKind::kList, EachValue<IsIn>,
     kMaxOne},
    {"hasValue", "HasValueConstraintComponent", ParameterKind::kAny,
     CheckHasValue},
    {"closed", "ClosedConstraintComponent", ParameterKind::kTrue, CheckClosed,
     kMaxOne},
    {"equals", "EqualsConstraintComponent", ParameterKind::kIri, CheckEquals},
    {"disjoint", "DisjointConstraintComponent", ParameterKind::kIri,
     CheckDisjoint},
    {"lessThan", "LessThanConstraintComponent", ParameterKind::kIri,
     CheckPair<IsLess>, false, kPropertyOnly},
    {"lessThanOrEquals", "LessThanOrEqualsConstraintComponent",
     ParameterKind::kIri, CheckPair<IsLessOrEqual>, false, kPropertyOnly},
    {"node", "NodeConstraintComponent", ParameterKind::kShape,
     EachValue<ConformsToNode>},
    {"property", "PropertyShapeComponent", ParameterKind::kPropertyShape,
     CheckProperty},
    {"or", "OrConstraintComponent", ParameterKind::kShapeList,
     EachValue<ConformsToAny>},
    {"xone", "XoneConstraintComponent", ParameterKind::kShapeList,
     EachValue<ConformsToOne>},
    {"and", "AndConstraintComponent", ParameterKind::kShapeList,
     EachValue<ConformsToAll>},
    {"not", "NotConstraintComponent", ParameterKind::kShape,
     EachValue<ConformsToNone>},
    {"qualifiedMinCount", "QualifiedMinCountConstraintComponent",
     ParameterKind::kQualified, CheckQualifiedMin, kMaxOne},
    {"qualifiedMaxCount", "QualifiedMaxCountConstraintComponent",
     ParameterKind::kQualified, CheckQualifiedMax, kMaxOne},
};

}  // namespace

const ConstraintComponent* FindComponent(std::string_view local) {
  for (const ConstraintComponent& component : kComponents) {
    if (local == component.parameter) return &component;
  }
  return nullptr;
}

}  // namespace kg_core::shacl
