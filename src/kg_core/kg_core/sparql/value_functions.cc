// Functions on numbers, times and hashes.
// https://www.w3.org/TR/sparql11-query/#func-numerics, #func-date-time,
// #func-hash

#include <openssl/evp.h>

#include <cmath>
#include <cstdlib>
#include <string>

#include "kg_core/rdf/namespaces.h"
#include "kg_core/sparql/functions.h"
#include "kg_core/sparql/values.h"
#include "kg_core/sparql/xsd_date_time.h"

namespace kg_core::sparql {
namespace {

kg_base::Decimal Absolute(const kg_base::Decimal& value) {
  return kg_base::Decimal{value.digits < 0 ? -value.digits : value.digits,
                          value.scale};
}

template <kg_base::Decimal (*kExact)(const kg_base::Decimal&),
          double (*kReal)(double)>
Answer Apply(FunctionContext&, const Arguments& a) {
  std::optional<XsdNumber> number = ToNumber(*a[0]);
  if (!number) return std::nullopt;
  number->exact = kExact(number->exact);
  number->real = kReal(number->real);
  return ToTerm(*number);
}

Answer Rand(FunctionContext& context, const Arguments&) {
  return DoubleLiteral(
      std::ldexp(static_cast<double>(context.random() >> 11), -53));
}

Answer Now(FunctionContext& context, const Arguments&) { return context.now; }

std::optional<DateTime> GetTime(const Arguments& a) {
  const Term& term = *a[0];
  if (!term.is_literal()) return std::nullopt;
  if (term.datatype == std::string(kXsd) + "date") return ParseDate(term.text);
  if (term.datatype != std::string(kXsd) + "dateTime") return std::nullopt;
  return ParseDateTime(term.text);
}

template <int DateTime::*kPart>
Answer GetPart(FunctionContext&, const Arguments& a) {
  const std::optional<DateTime> time = GetTime(a);
  if (!time) return std::nullopt;
  return IntegerLiteral((*time).*kPart);
}

Answer Seconds(FunctionContext&, const Arguments& a) {
  const std::optional<DateTime> time = GetTime(a);
  if (!time) return std::nullopt;
  return Literal(ToString(time->second), std::string(kXsd) + "decimal");
}

// https://www.w3.org/TR/sparql11-query/#func-timezone
Answer TimeZone(FunctionContext&, const Arguments& a) {
  const std::optional<DateTime> time = GetTime(a);
  if (!time || !time->zone_min) return std::nullopt;
  const int minutes = std::abs(*time->zone_min);
  std::string text = *time->zone_min < 0 ? "-PT" : "PT";
  if (minutes >= 60) text += std::to_string(minutes / 60) + "H";
  if (minutes % 60 != 0) text += std::to_string(minutes % 60) + "M";
  if (minutes == 0) text += "0S";
  return Literal(text, std::string(kXsd) + "dayTimeDuration");
}

// https://www.w3.org/TR/sparql11-query/#func-tz: the time zone as written.
Answer Tz(FunctionContext&, const Arguments& a) {
  const std::optional<DateTime> time = GetTime(a);
  if (!time) return std::nullopt;
  if (!time->zone_min) return Literal("");
  const std::string& text = a[0]->text;
  return Literal(text.back() == 'Z' ? "Z" : text.substr(text.size() - 6));
}

Answer Digest(const Arguments& a, const EVP_MD* method) {
  if (!IsString(*a[0])) return std::nullopt;
  unsigned char digest[EVP_MAX_MD_SIZE];
  unsigned length = 0;
  if (EVP_Digest(a[0]->text.data(), a[0]->text.size(), digest, &length, method,
                 nullptr) != 1) {
    return std::nullopt;
  }
  constexpr char kHex[] = "0123456789abcdef";
  std::string text;
  for (unsigned i = 0; i < length; ++i) {
    text.push_back(kHex[digest[i] >> 4]);
    text.push_back(kHex[digest[i] & 15]);
  }
  return Literal(text);
}

template <const EVP_MD* (*kMethod)()>
Answer Hash(FunctionContext&, const Arguments& a) {
  return Digest(a, kMethod());
}

}  // namespace

std::vector<SparqlFunction> NumberFunctions() {
  return {{"ABS", 1, 1, Apply<Absolute, std::fabs>},
          {"ROUND", 1, 1, Apply<kg_base::Round, RoundHalfUp>},
          {"CEIL", 1, 1, Apply<kg_base::Ceil, std::ceil>},
          {"FLOOR", 1, 1, Apply<kg_base::Floor, std::floor>},
          {"RAND", 0, 0, Rand}};
}

std::vector<SparqlFunction> TimeFunctions() {
  return {{"NOW", 0, 0, Now},
          {"YEAR", 1, 1, GetPart<&DateTime::year>},
          {"MONTH", 1, 1, GetPart<&DateTime::month>},
          {"DAY", 1, 1, GetPart<&DateTime::day>},
          {"HOURS", 1, 1, GetPart<&DateTime::hour>},
          {"MINUTES", 1, 1, GetPart<&DateTime::minute>},
          {"SECONDS", 1, 1, Seconds},
          {"TIMEZONE", 1, 1, TimeZone},
          {"TZ", 1, 1, Tz}};
}

std::vector<SparqlFunction> HashFunctions() {
  return {{"MD5", 1, 1, Hash<EVP_md5>},
          {"SHA1", 1, 1, Hash<EVP_sha1>},
          {"SHA256", 1, 1, Hash<EVP_sha256>},
          {"SHA384", 1, 1, Hash<EVP_sha384>},
          {"SHA512", 1, 1, Hash<EVP_sha512>}};
}

}  // namespace kg_core::sparql
