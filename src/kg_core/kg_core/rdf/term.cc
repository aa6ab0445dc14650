#include "kg_core/rdf/term.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "absl/strings/charconv.h"
#include "kg_base/common/text.h"
#include "kg_core/rdf/namespaces.h"

namespace kg_core {
namespace {

std::string Xsd(std::string_view name) { return kXsd + std::string(name); }

// The local name if `datatype` is one of XML Schema's, else empty.
std::string_view XsdName(const Term& term) {
  const std::string_view prefix = kXsd;
  const std::string_view datatype = term.datatype;
  if (!term.is_literal() || datatype.substr(0, prefix.size()) != prefix) {
    return {};
  }
  return datatype.substr(prefix.size());
}

constexpr char kBlankStart[] = "_:";
constexpr double kInf = std::numeric_limits<double>::infinity();

// Integer types by value range, https://www.w3.org/TR/xmlschema11-2/#integer.
struct IntegerType {
  std::string_view name;
  std::string_view min, max;  // Empty: unbounded.
};
constexpr IntegerType kIntegerTypes[] = {
    {"integer", "", ""},
    {"nonNegativeInteger", "0", ""},
    {"positiveInteger", "1", ""},
    {"nonPositiveInteger", "", "0"},
    {"negativeInteger", "", "-1"},
    {"long", "-9223372036854775808", "9223372036854775807"},
    {"int", "-2147483648", "2147483647"},
    {"short", "-32768", "32767"},
    {"byte", "-128", "127"},
    {"unsignedLong", "0", "18446744073709551615"},
    {"unsignedInt", "0", "4294967295"},
    {"unsignedShort", "0", "65535"},
    {"unsignedByte", "0", "255"},
};

const IntegerType* FindIntegerType(std::string_view name) {
  for (const IntegerType& type : kIntegerTypes) {
    if (type.name == name) return &type;
  }
  return nullptr;
}

// Lexical form of a number: the forms of
// https://www.w3.org/TR/turtle/#grammar-production-INTEGER and its neighbours,
// with XML Schema's additional decimal "5.".
struct NumberForm {
  bool valid = false;
  bool has_point = false;
  bool has_fraction = false;  // Digits after the point.
  bool has_exponent = false;
};

std::size_t SkipSign(std::string_view s, std::size_t at) {
  return at < s.size() && (s[at] == '+' || s[at] == '-') ? at + 1 : at;
}

std::size_t SkipDigits(std::string_view s, std::size_t at) {
  while (at < s.size() && s[at] >= '0' && s[at] <= '9') ++at;
  return at;
}

NumberForm FindForm(std::string_view s) {
  NumberForm form;
  const std::size_t start = SkipSign(s, 0);
  std::size_t at = SkipDigits(s, start);
  std::size_t digits = at - start;
  // Digits may come before the point, after it or both.
  if (at < s.size() && s[at] == '.') {
    form.has_point = true;
    const std::size_t end = SkipDigits(s, at + 1);
    form.has_fraction = end > at + 1;
    digits += end - (at + 1);
    at = end;
  }
  if (digits == 0) return form;
  if (at < s.size() && (s[at] == 'e' || s[at] == 'E')) {
    form.has_exponent = true;
    const std::size_t power = SkipSign(s, at + 1);
    at = SkipDigits(s, power);
    if (at == power) return form;
  }
  form.valid = at == s.size();
  return form;
}

// Precondition: `s` is a valid number. Rounds to nearest; overflow gives
// infinity as in XML Schema. Independent of the locale.
double ToDouble(std::string_view s) {
  if (s[0] == '+') s.remove_prefix(1);
  double value = 0.0;
  const auto result = absl::from_chars(s.data(), s.data() + s.size(), value);
  const bool too_large =
      result.ec == std::errc::result_out_of_range && std::abs(value) > 1.0;
  return too_large ? std::copysign(kInf, value) : value;
}

std::optional<double> FloatingValue(std::string_view s) {
  if (s == "INF" || s == "+INF") return kInf;
  if (s == "-INF") return -kInf;
  if (s == "NaN") return std::numeric_limits<double>::quiet_NaN();
  if (!FindForm(s).valid) return std::nullopt;
  return ToDouble(s);
}

std::optional<double> DecimalValue(std::string_view s) {
  const NumberForm form = FindForm(s);
  if (!form.valid || form.has_exponent) return std::nullopt;
  return ToDouble(s);
}

// -1, 0 or 1; exact for any number of digits. Precondition: both are integers.
int CompareIntegers(std::string_view a, std::string_view b) {
  const auto digits = [](std::string_view s) {
    s.remove_prefix(SkipSign(s, 0));
    while (!s.empty() && s[0] == '0') s.remove_prefix(1);
    return s;
  };
  const std::string_view x = digits(a);
  const std::string_view y = digits(b);
  const int x_sign = x.empty() ? 0 : a[0] == '-' ? -1 : 1;
  const int y_sign = y.empty() ? 0 : b[0] == '-' ? -1 : 1;
  if (x_sign != y_sign) return x_sign < y_sign ? -1 : 1;
  if (x.size() != y.size()) return x.size() < y.size() ? -x_sign : x_sign;
  const int order = x.compare(y);
  return order == 0 ? 0 : order < 0 ? -x_sign : x_sign;
}

std::optional<double> IntegerValue(std::string_view s,
                                   const IntegerType& type) {
  const NumberForm form = FindForm(s);
  if (!form.valid || form.has_point || form.has_exponent) return std::nullopt;
  const bool is_below = !type.min.empty() && CompareIntegers(s, type.min) < 0;
  const bool is_above = !type.max.empty() && CompareIntegers(s, type.max) > 0;
  if (is_below || is_above) return std::nullopt;
  return ToDouble(s);
}

void AppendCodeEscape(unsigned char c, std::string* out) {
  constexpr char kHex[] = "0123456789ABCDEF";
  *out += "\\u00";
  out->push_back(kHex[c >> 4]);
  out->push_back(kHex[c & 15]);
}

// The letter of a one-letter escape, else 0.
char EscapeLetter(char c) {
  switch (c) {
    case '"':
    case '\\':
      return c;
    case '\n':
      return 'n';
    case '\r':
      return 'r';
    case '\t':
      return 't';
    case '\b':
      return 'b';
    case '\f':
      return 'f';
    default:
      return 0;
  }
}

std::string Quoted(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (const char letter = EscapeLetter(c)) {
      out.push_back('\\');
      out.push_back(letter);
    } else if (byte < 0x20 || byte == 0x7F) {
      AppendCodeEscape(byte, &out);
    } else {
      out.push_back(c);
    }
  }
  return out + "\"";
}

// https://www.w3.org/TR/n-triples/#grammar-production-IRIREF
std::string AngledIri(std::string_view iri) {
  std::string out = "<";
  for (const char c : iri) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = byte > 0x20 && std::string_view("<>\"{}|^`\\").find(c) ==
                                          std::string_view::npos;
    if (plain) {
      out.push_back(c);
    } else {
      AppendCodeEscape(byte, &out);
    }
  }
  return out + ">";
}

std::string IriToTurtle(std::string_view iri) {
  std::string short_form = AbbreviateIri(iri);
  return short_form[0] == '<' ? AngledIri(iri) : short_form;
}

// True if the literal, written without quotes and datatype in Turtle, reads
// back as the same term. https://www.w3.org/TR/turtle/#abbrev
bool IsBareInTurtle(const Term& term) {
  const std::string_view type = XsdName(term);
  if (type == "boolean") return term.text == "true" || term.text == "false";
  const NumberForm form = FindForm(term.text);
  if (!form.valid) return false;
  if (type == "integer") return !form.has_point && !form.has_exponent;
  if (type == "decimal") return form.has_fraction && !form.has_exponent;
  return type == "double" && form.has_exponent;
}

auto AsTuple(const Term& t) {
  return std::tie(t.kind, t.text, t.datatype, t.language);
}

}  // namespace

bool operator==(const Term& a, const Term& b) {
  return AsTuple(a) == AsTuple(b);
}
bool operator!=(const Term& a, const Term& b) { return !(a == b); }
bool operator<(const Term& a, const Term& b) { return AsTuple(a) < AsTuple(b); }

Term Iri(std::string iri) { return {Term::Kind::kIri, std::move(iri), {}, {}}; }

Term Blank(std::string label) {
  return {Term::Kind::kBlank, std::move(label), {}, {}};
}

std::string ToGraphName(const Term& graph) {
  return graph.is_blank() ? kBlankStart + graph.text : graph.text;
}

Term GraphFromName(std::string_view name) {
  const std::string_view start = kBlankStart;
  if (name.substr(0, start.size()) != start) return Iri(std::string(name));
  return Blank(std::string(name.substr(start.size())));
}

Term Literal(std::string lexical) {
  return Literal(std::move(lexical), Xsd("string"));
}

Term Literal(std::string lexical, std::string datatype) {
  return {Term::Kind::kLiteral, std::move(lexical), std::move(datatype), {}};
}

Term LanguageLiteral(std::string lexical, std::string language) {
  return {Term::Kind::kLiteral, std::move(lexical),
          kRdf + std::string("langString"), kg_base::ToLowerAscii(language)};
}

Term DoubleLiteral(double value) {
  if (std::isnan(value)) return Literal("NaN", Xsd("double"));
  if (std::isinf(value)) {
    return Literal(value > 0 ? "INF" : "-INF", Xsd("double"));
  }
  char digits[32];
  const auto end = std::to_chars(digits, digits + sizeof(digits), value).ptr;
  return Literal(std::string(digits, end), Xsd("double"));
}

Term IntegerLiteral(long long value) {
  return Literal(std::to_string(value), Xsd("integer"));
}

Term BooleanLiteral(bool value) {
  return Literal(value ? "true" : "false", Xsd("boolean"));
}

std::optional<double> NumericValue(const Term& term) {
  const std::string_view type = XsdName(term);
  if (type == "double" || type == "float") return FloatingValue(term.text);
  if (type == "decimal") return DecimalValue(term.text);
  const IntegerType* integer = FindIntegerType(type);
  if (integer == nullptr) return std::nullopt;
  return IntegerValue(term.text, *integer);
}

std::string ToNTriples(const Term& term) {
  if (term.is_iri()) return AngledIri(term.text);
  if (term.is_blank()) return "_:" + term.text;
  const std::string quoted = Quoted(term.text);
  if (!term.language.empty()) return quoted + "@" + term.language;
  if (XsdName(term) == "string") return quoted;
  return quoted + "^^" + AngledIri(term.datatype);
}

std::string ToTurtle(const Term& term) {
  if (term.is_iri()) return IriToTurtle(term.text);
  if (term.is_blank()) return "_:" + term.text;
  if (IsBareInTurtle(term)) return term.text;
  const std::string quoted = Quoted(term.text);
  if (!term.language.empty()) return quoted + "@" + term.language;
  if (XsdName(term) == "string") return quoted;
  return quoted + "^^" + IriToTurtle(term.datatype);
}

std::ostream& operator<<(std::ostream& out, const Term& term) {
  return out << ToTurtle(term);
}

}  // namespace kg_core
