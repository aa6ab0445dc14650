#include "kg_core/sparql/values.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <string_view>

#include "kg_core/rdf/namespaces.h"
#include "kg_core/sparql/xsd_date_time.h"

namespace kg_core::sparql {
namespace {

constexpr char kLangString[] =
    "http://www.w3.org/1999/02/22-rdf-syntax-ns#langString";

// The local name ("integer") of an XSD datatype; empty for other datatypes.
std::string_view XsdName(const std::string& datatype) {
  const std::string_view view(datatype);
  const std::string_view xsd(kXsd);
  if (view.substr(0, xsd.size()) != xsd) return {};
  return view.substr(xsd.size());
}

// https://www.w3.org/TR/sparql11-query/#operandDataTypes
constexpr std::string_view kIntegerTypes[] = {"integer",
                                              "nonPositiveInteger",
                                              "negativeInteger",
                                              "long",
                                              "int",
                                              "short",
                                              "byte",
                                              "nonNegativeInteger",
                                              "unsignedLong",
                                              "unsignedInt",
                                              "unsignedShort",
                                              "unsignedByte",
                                              "positiveInteger"};

std::optional<XsdNumber::Type> NumericType(const std::string& datatype) {
  const std::string_view name = XsdName(datatype);
  if (name.empty()) return std::nullopt;
  if (name == "decimal") return XsdNumber::Type::kDecimal;
  if (name == "double") return XsdNumber::Type::kDouble;
  if (name == "float") return XsdNumber::Type::kFloat;
  for (const std::string_view type : kIntegerTypes) {
    if (name == type) return XsdNumber::Type::kInteger;
  }
  return std::nullopt;
}

// Kinds of values, in the order of ORDER BY.
enum class ValueKind {
  kBlank,
  kIri,
  kNumber,
  kBoolean,
  kDateTime,
  kDate,
  kString,
  kLanguageString,
  kUnknown,  // Other datatype or invalid lexical form.
};

std::optional<bool> ToBoolean(const Term& term) {
  if (term.text == "true" || term.text == "1") return true;
  if (term.text == "false" || term.text == "0") return false;
  return std::nullopt;
}

ValueKind LiteralKind(const Term& term) {
  if (!term.language.empty()) return ValueKind::kLanguageString;
  const std::string_view name = XsdName(term.datatype);
  if (name == "string") return ValueKind::kString;
  if (name == "boolean" && ToBoolean(term)) return ValueKind::kBoolean;
  if (name == "dateTime" && ParseDateTime(term.text)) {
    return ValueKind::kDateTime;
  }
  if (name == "date" && ParseDate(term.text)) return ValueKind::kDate;
  if (ToNumber(term)) return ValueKind::kNumber;
  return ValueKind::kUnknown;
}

ValueKind GetKind(const Term& term) {
  switch (term.kind) {
    case Term::Kind::kBlank:
      return ValueKind::kBlank;
    case Term::Kind::kIri:
      return ValueKind::kIri;
    case Term::Kind::kLiteral:
      return LiteralKind(term);
  }
  return ValueKind::kUnknown;
}

Order FromSign(int sign) {
  return sign < 0 ? Order::kLess : sign > 0 ? Order::kGreater : Order::kEqual;
}

int Sign(int value) { return value < 0 ? -1 : value > 0 ? 1 : 0; }

// A term with its parsed value, so that it is parsed once.
struct ComparableValue {
  explicit ComparableValue(const Term& read)
      : term(&read), kind(GetKind(read)) {
    if (kind == ValueKind::kNumber) number = *ToNumber(read);
    if (kind == ValueKind::kBoolean) truth = *ToBoolean(read);
    if (kind == ValueKind::kDateTime) time = *ParseDateTime(read.text);
    if (kind == ValueKind::kDate) time = *ParseDate(read.text);
  }

  const Term* term;
  ValueKind kind;
  bool truth = false;
  XsdNumber number;
  DateTime time;
};

// The operators '=' and '<': exact numbers are promoted to doubles if one is.
Order CompareNumbers(const XsdNumber& a, const XsdNumber& b) {
  if (a.is_exact() && b.is_exact()) {
    return FromSign(Compare(a.exact, b.exact));
  }
  const double x = a.ToDouble();
  const double y = b.ToDouble();
  if (x < y) return Order::kLess;
  if (x > y) return Order::kGreater;
  return x == y ? Order::kEqual : Order::kNone;
}

// Exact order; a NaN comes before the other numbers.
int OrderNumbers(const XsdNumber& a, const XsdNumber& b) {
  const bool a_is_nan = !a.is_exact() && std::isnan(a.real);
  const bool b_is_nan = !b.is_exact() && std::isnan(b.real);
  if (a_is_nan || b_is_nan) return int{b_is_nan} - int{a_is_nan};
  if (a.is_exact() == b.is_exact()) {
    if (a.is_exact()) return Compare(a.exact, b.exact);
    return a.real < b.real ? -1 : a.real > b.real ? 1 : 0;
  }
  if (b.is_exact()) return -kg_base::CompareWithDouble(b.exact, a.real);
  return kg_base::CompareWithDouble(a.exact, b.real);
}

// Order of two values of the same comparable kind.
Order CompareSameKind(const ComparableValue& a, const ComparableValue& b) {
  switch (a.kind) {
    case ValueKind::kNumber:
      return CompareNumbers(a.number, b.number);
    case ValueKind::kBoolean:
      return FromSign(int{a.truth} - int{b.truth});
    case ValueKind::kDateTime:
    case ValueKind::kDate:
      return FromSign(Compare(a.time, b.time));
    case ValueKind::kString:
    case ValueKind::kLanguageString:
    case ValueKind::kBlank:
    case ValueKind::kIri:
    case ValueKind::kUnknown:
      break;
  }
  return FromSign(a.term->text.compare(b.term->text));
}

int OrderSameKind(const ComparableValue& a, const ComparableValue& b) {
  if (a.kind == ValueKind::kNumber) return OrderNumbers(a.number, b.number);
  switch (CompareSameKind(a, b)) {
    case Order::kLess:
      return -1;
    case Order::kGreater:
      return 1;
    case Order::kNone:
    case Order::kEqual:
      break;
  }
  if (a.kind == ValueKind::kDateTime) return 0;
  const int by_language = Sign(a.term->language.compare(b.term->language));
  return by_language != 0 ? by_language
                          : Sign(a.term->datatype.compare(b.term->datatype));
}

int OrderOfValues(const ComparableValue& a, const ComparableValue& b) {
  if (a.kind != b.kind) return a.kind < b.kind ? -1 : 1;
  return OrderSameKind(a, b);
}

std::string FormatReal(double value, XsdNumber::Type type) {
  if (type == XsdNumber::Type::kDouble) return DoubleLiteral(value).text;
  if (std::isnan(value)) return "NaN";
  if (std::isinf(value)) return value < 0 ? "-INF" : "INF";
  char text[64];
  for (int precision = 1; precision <= 9; ++precision) {
    std::snprintf(text, sizeof text, "%.*g", precision, value);
    if (std::strtof(text, nullptr) == static_cast<float>(value)) break;
  }
  return text;
}

std::optional<kg_base::Decimal> CalculateExact(Arithmetic operation,
                                               const kg_base::Decimal& a,
                                               const kg_base::Decimal& b) {
  switch (operation) {
    case Arithmetic::kAdd:
      return Add(a, b);
    case Arithmetic::kSubtract:
      return Subtract(a, b);
    case Arithmetic::kMultiply:
      return Multiply(a, b);
    case Arithmetic::kDivide:
      return Divide(a, b);
  }
  return std::nullopt;
}

double CalculateReal(Arithmetic operation, double a, double b) {
  switch (operation) {
    case Arithmetic::kAdd:
      return a + b;
    case Arithmetic::kSubtract:
      return a - b;
    case Arithmetic::kMultiply:
      return a * b;
    case Arithmetic::kDivide:
      return a / b;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

bool IsNumericType(const std::string& datatype) {
  return NumericType(datatype).has_value();
}

double RoundHalfUp(double value) {
  // Not floor(value + 0.5), which rounds the sum; the difference below is exact
  // wherever it decides.
  const double down = std::floor(value);
  const double rounded = value - down >= 0.5 ? down + 1 : down;
  return std::copysign(rounded, value);
}

std::optional<double> ParseDouble(const std::string& text) {
  if (text == "INF" || text == "+INF") return HUGE_VAL;
  if (text == "-INF") return -HUGE_VAL;
  if (text == "NaN") return std::numeric_limits<double>::quiet_NaN();
  if (text.empty() ||
      text.find_first_not_of("0123456789+-.eE") != std::string::npos) {
    return std::nullopt;
  }
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (end != text.c_str() + text.size()) return std::nullopt;
  return value;
}

std::optional<XsdNumber> ToNumber(const Term& term) {
  if (!term.is_literal()) return std::nullopt;
  const std::optional<XsdNumber::Type> type = NumericType(term.datatype);
  if (!type) return std::nullopt;
  XsdNumber number;
  number.type = *type;
  if (number.is_exact()) {
    const std::optional<kg_base::Decimal> value =
        kg_base::ParseDecimal(term.text);
    // An xsd:integer has no decimal point.
    const bool whole = term.text.find('.') == std::string::npos;
    if (!value || (*type == XsdNumber::Type::kInteger && !whole)) {
      return std::nullopt;
    }
    const std::string_view name = XsdName(term.datatype);
    const bool has_range = name != "integer" && name != "decimal";
    if (has_range && !NumericValue(term)) return std::nullopt;
    number.exact = *value;
    return number;
  }
  const std::optional<double> value = ParseDouble(term.text);
  if (!value) return std::nullopt;
  number.real = *type == XsdNumber::Type::kFloat
                    ? static_cast<double>(static_cast<float>(*value))
                    : *value;
  return number;
}

Term ToTerm(const XsdNumber& number) {
  constexpr const char* kNames[] = {"integer", "decimal", "float", "double"};
  const std::string datatype =
      std::string(kXsd) + kNames[static_cast<int>(number.type)];
  return Literal(number.is_exact() ? ToString(number.exact)
                                   : FormatReal(number.real, number.type),
                 datatype);
}

std::optional<XsdNumber> Calculate(Arithmetic operation, const XsdNumber& a,
                                   const XsdNumber& b) {
  XsdNumber result;
  result.type = std::max(a.type, b.type);
  if (result.is_exact()) {
    if (operation == Arithmetic::kDivide) {
      result.type = XsdNumber::Type::kDecimal;
    }
    const std::optional<kg_base::Decimal> exact =
        CalculateExact(operation, a.exact, b.exact);
    if (!exact) return std::nullopt;
    result.exact = *exact;
    return result;
  }
  result.real = CalculateReal(operation, a.ToDouble(), b.ToDouble());
  if (result.type == XsdNumber::Type::kFloat) {
    result.real = static_cast<double>(static_cast<float>(result.real));
  }
  return result;
}

bool IsString(const Term& term) {
  return term.is_literal() && term.language.empty() &&
         XsdName(term.datatype) == "string";
}

bool IsStringLike(const Term& term) {
  return IsString(term) ||
         (term.is_literal() &&
          (!term.language.empty() || term.datatype == kLangString));
}

std::optional<bool> EffectiveBoolean(const Term& term) {
  if (!term.is_literal()) return std::nullopt;
  if (IsString(term)) return !term.text.empty();
  if (XsdName(term.datatype) == "boolean") {
    return ToBoolean(term).value_or(false);
  }
  if (!IsNumericType(term.datatype)) return std::nullopt;
  const std::optional<XsdNumber> number = ToNumber(term);
  if (!number) return false;
  const double value = number->ToDouble();
  return !(std::isnan(value) || value == 0.0);
}

std::optional<bool> Equal(const Term& a, const Term& b) {
  const ComparableValue x(a);
  const ComparableValue y(b);
  const bool literals = a.is_literal() && b.is_literal();
  if (x.kind == y.kind && x.kind != ValueKind::kUnknown && literals) {
    if (x.kind == ValueKind::kLanguageString) return a == b;
    return CompareSameKind(x, y) == Order::kEqual;
  }
  if (a == b) return true;
  const bool unknown =
      x.kind == ValueKind::kUnknown || y.kind == ValueKind::kUnknown;
  // A text with a language equals no value of another datatype.
  const bool one_has_language = a.language.empty() != b.language.empty();
  if (literals && unknown && !one_has_language) return std::nullopt;
  return false;
}

std::optional<Order> Compare(const Term& a, const Term& b) {
  const ComparableValue x(a);
  const ComparableValue y(b);
  if (x.kind != y.kind) return std::nullopt;
  switch (x.kind) {
    case ValueKind::kNumber:
    case ValueKind::kBoolean:
    case ValueKind::kDateTime:
    case ValueKind::kDate:
    case ValueKind::kString:
      return CompareSameKind(x, y);
    case ValueKind::kLanguageString:
    case ValueKind::kBlank:
    case ValueKind::kIri:
    case ValueKind::kUnknown:
      break;
  }
  return std::nullopt;
}

int CompareTerms(const Term* a, const Term* b) {
  if (a == nullptr || b == nullptr) {
    return int{a != nullptr} - int{b != nullptr};
  }
  return OrderOfValues(ComparableValue(*a), ComparableValue(*b));
}

std::vector<int> ComputeRanks(const std::vector<const Term*>& terms,
                              absl::FunctionRef<void()> step) {
  std::vector<ComparableValue> values;
  values.reserve(terms.size());
  for (const Term* term : terms) {
    step();
    values.emplace_back(*term);
  }
  std::vector<std::size_t> sorted(terms.size());
  std::iota(sorted.begin(), sorted.end(), std::size_t{0});
  std::stable_sort(sorted.begin(), sorted.end(),
                   [&](std::size_t a, std::size_t b) {
                     step();
                     return OrderOfValues(values[a], values[b]) < 0;
                   });
  std::vector<int> ranks(terms.size());
  // Terms that compare equal share a rank.
  int rank = 0;
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    if (OrderOfValues(values[sorted[i - 1]], values[sorted[i]]) != 0) ++rank;
    ranks[sorted[i]] = rank;
  }
  return ranks;
}

}  // namespace kg_core::sparql
