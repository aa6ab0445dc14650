// Casts by XSD constructor functions.
// https://www.w3.org/TR/sparql11-query/#FunctionMapping

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "kg_core/rdf/namespaces.h"
#include "kg_core/sparql/functions.h"
#include "kg_core/sparql/values.h"
#include "kg_core/sparql/xsd_date_time.h"

namespace kg_core::sparql {
namespace {

std::string Xsd(const char* name) { return std::string(kXsd) + name; }

// Strips surrounding white space, which lexical forms may have.
std::string Stripped(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

std::optional<bool> ParseBoolean(const Term& term) {
  if (term.datatype != Xsd("boolean")) return std::nullopt;
  if (term.text == "true" || term.text == "1") return true;
  if (term.text == "false" || term.text == "0") return false;
  return std::nullopt;
}

// A float or double in XPath notation: "1.25", "1.0E7".
// https://www.w3.org/TR/xpath-functions/#casting-to-string
std::string RealText(const XsdNumber& number) {
  const double size = std::fabs(number.real);
  const bool plain = size == 0 || (size >= 1e-6 && size < 1e6);
  // The shortest digits that read back the same.
  const std::string shortest = ToTerm(number).text;
  if (!std::isfinite(number.real)) return shortest;
  const std::optional<kg_base::Decimal> exact =
      ParseDouble(shortest) ? kg_base::FromDouble(*ParseDouble(shortest))
                            : std::nullopt;
  if (plain && exact) return ToString(*exact);
  char text[64];
  for (int digits = 1; digits <= 17; ++digits) {
    std::snprintf(text, sizeof text, "%.*E", digits, number.real);
    if (std::strtod(text, nullptr) == *ParseDouble(shortest)) break;
  }
  std::string out(text);
  const std::size_t e = out.find('E');
  const int exponent = std::atoi(out.c_str() + e + 1);
  return out.substr(0, e) + "E" + std::to_string(exponent);
}

Answer ToStringCast(FunctionContext&, const Arguments& a) {
  if (a[0]->is_blank()) return std::nullopt;
  if (const std::optional<bool> truth = ParseBoolean(*a[0])) {
    return Literal(*truth ? "true" : "false");
  }
  const std::optional<XsdNumber> number = ToNumber(*a[0]);
  if (!number) return Literal(a[0]->text);
  return Literal(number->is_exact() ? ToString(number->exact)
                                    : RealText(*number));
}

Answer ToBooleanCast(FunctionContext&, const Arguments& a) {
  const Term& term = *a[0];
  if (const std::optional<bool> value = ParseBoolean(term)) {
    return BooleanLiteral(*value);
  }
  if (const std::optional<XsdNumber> number = ToNumber(term)) {
    const double value = number->ToDouble();
    return BooleanLiteral(!(std::isnan(value) || value == 0.0));
  }
  if (!IsString(term)) return std::nullopt;
  const std::string text = Stripped(term.text);
  if (text == "true" || text == "1") return BooleanLiteral(true);
  if (text == "false" || text == "0") return BooleanLiteral(false);
  return std::nullopt;
}

// Converts numbers, booleans and strings to a number; a string is parsed as
// `type`.
std::optional<XsdNumber> AsNumber(const Term& term, XsdNumber::Type type) {
  if (const std::optional<XsdNumber> number = ToNumber(term)) return number;
  XsdNumber number;
  if (const std::optional<bool> truth = ParseBoolean(term)) {
    number.exact.digits = *truth ? 1 : 0;
    return number;
  }
  if (!IsString(term)) return std::nullopt;
  number.type = type;
  return ToNumber(Literal(Stripped(term.text), ToTerm(number).datatype));
}

template <XsdNumber::Type kType>
Answer ToNumberCast(FunctionContext&, const Arguments& a) {
  std::optional<XsdNumber> number = AsNumber(*a[0], kType);
  if (!number) return std::nullopt;
  const bool to_exact = kType <= XsdNumber::Type::kDecimal;
  if (to_exact && !number->is_exact()) {
    const std::optional<kg_base::Decimal> exact =
        kg_base::FromDouble(number->real);
    if (!exact) return std::nullopt;
    number->exact = *exact;
  }
  if (!to_exact) number->real = number->ToDouble();
  if (kType == XsdNumber::Type::kInteger) {
    number->exact = Truncate(number->exact);
  }
  number->type = kType;
  return ToTerm(*number);
}

Answer ToDateTimeCast(FunctionContext&, const Arguments& a) {
  const Term& term = *a[0];
  if (!IsString(term) && term.datatype != Xsd("dateTime") &&
      term.datatype != Xsd("date")) {
    return std::nullopt;
  }
  std::string text = Stripped(term.text);
  if (term.datatype == Xsd("date") && text.size() >= 10) {
    text.insert(10, "T00:00:00");
  }
  if (!ParseDateTime(text)) return std::nullopt;
  return Literal(text, Xsd("dateTime"));
}

Answer ToDateCast(FunctionContext&, const Arguments& a) {
  const Term& term = *a[0];
  std::string text = Stripped(term.text);
  if (term.datatype == Xsd("dateTime")) {
    const std::optional<DateTime> time = ParseDateTime(text);
    const std::size_t t = text.find('T');
    if (!time) return std::nullopt;
    const std::size_t zone = text.find_first_of("Z+-", t);
    text = text.substr(0, t) +
           (zone == std::string::npos ? "" : text.substr(zone));
  } else if (!IsString(term) && term.datatype != Xsd("date")) {
    return std::nullopt;
  }
  if (!ParseDate(text)) return std::nullopt;
  return Literal(text, Xsd("date"));
}

}  // namespace

std::vector<SparqlFunction> CastFunctions() {
  return {{Xsd("string"), 1, 1, ToStringCast},
          {Xsd("boolean"), 1, 1, ToBooleanCast},
          {Xsd("integer"), 1, 1, ToNumberCast<XsdNumber::Type::kInteger>},
          {Xsd("decimal"), 1, 1, ToNumberCast<XsdNumber::Type::kDecimal>},
          {Xsd("float"), 1, 1, ToNumberCast<XsdNumber::Type::kFloat>},
          {Xsd("double"), 1, 1, ToNumberCast<XsdNumber::Type::kDouble>},
          {Xsd("dateTime"), 1, 1, ToDateTimeCast},
          {Xsd("date"), 1, 1, ToDateCast}};
}

}  // namespace kg_core::sparql
