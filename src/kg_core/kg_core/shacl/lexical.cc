#include "kg_core/shacl/lexical.h"

#include <algorithm>
#include <cstdlib>
#include <string>

#include "kg_core/rdf/namespaces.h"

namespace kg_core::shacl {
namespace {

#define KG_ZONE "(Z|[+-](0\\d|1[0-3]):[0-5]\\d|[+-]14:00)?$"
#define KG_YEAR "^-?([1-9]\\d{3,}|0\\d{3})"
#define KG_MONTH "(0[1-9]|1[0-2])"
#define KG_DAY "(0[1-9]|[12]\\d|3[01])"
#define KG_TIME \
  "(([01]\\d|2[0-3]):[0-5]\\d:[0-5]\\d(\\.\\d+)?|24:00:00(\\.0+)?)"

constexpr char kInteger[] = "^[+-]?\\d+$";
constexpr char kReal[] =
    "^([+-]?(\\d+(\\.\\d*)?|\\.\\d+)([eE][+-]?\\d+)?|[+-]?INF|NaN)$";

struct LexicalRow {
  const char* datatype;  // Local name in xsd:.
  const char* pattern;
  // Integers only: inclusive bounds, null for none.
  const char* least = nullptr;
  const char* most = nullptr;
};
constexpr LexicalRow kRows[] = {
    {"boolean", "^(true|false|0|1)$"},
    {"decimal", "^[+-]?(\\d+(\\.\\d*)?|\\.\\d+)$"},
    {"double", kReal},
    {"float", kReal},
    {"integer", kInteger},
    {"long", kInteger, "-9223372036854775808", "9223372036854775807"},
    {"int", kInteger, "-2147483648", "2147483647"},
    {"short", kInteger, "-32768", "32767"},
    {"byte", kInteger, "-128", "127"},
    {"nonNegativeInteger", kInteger, "0"},
    {"positiveInteger", kInteger, "1"},
    {"nonPositiveInteger", kInteger, nullptr, "0"},
    {"negativeInteger", kInteger, nullptr, "-1"},
    {"unsignedLong", kInteger, "0", "18446744073709551615"},
    {"unsignedInt", kInteger, "0", "4294967295"},
    {"unsignedShort", kInteger, "0", "65535"},
    {"unsignedByte", kInteger, "0", "255"},
    {"dateTime", KG_YEAR "-" KG_MONTH "-" KG_DAY "T" KG_TIME KG_ZONE},
    {"dateTimeStamp", KG_YEAR "-" KG_MONTH "-" KG_DAY "T" KG_TIME
                              "(Z|[+-](0\\d|1[0-3]):[0-5]\\d|[+-]14:00)$"},
    {"date", KG_YEAR "-" KG_MONTH "-" KG_DAY KG_ZONE},
    {"time", "^" KG_TIME KG_ZONE},
    {"gYear", KG_YEAR KG_ZONE},
    {"gYearMonth", KG_YEAR "-" KG_MONTH KG_ZONE},
    {"gMonth", "^--" KG_MONTH KG_ZONE},
    {"gDay", "^---" KG_DAY KG_ZONE},
    {"gMonthDay", "^--" KG_MONTH "-" KG_DAY KG_ZONE},
    {"duration",
     "^-?P(?=.)(\\d+Y)?(\\d+M)?(\\d+D)?"
     "(T(?=.)(\\d+H)?(\\d+M)?(\\d+(\\.\\d+)?S)?)?$"},
    {"dayTimeDuration",
     "^-?P(?=.)(\\d+D)?(T(?=.)(\\d+H)?(\\d+M)?(\\d+(\\.\\d+)?S)?)?$"},
    {"yearMonthDuration", "^-?P(?=.)(\\d+Y)?(\\d+M)?$"},
    {"hexBinary", "^([0-9a-fA-F]{2})*$"},
    {"language", "^[a-zA-Z]{1,8}(-[a-zA-Z0-9]{1,8})*$"},
    {"anyURI", "^[^\\s<>\"{}|\\\\^`]*$"},
};

#undef KG_ZONE
#undef KG_YEAR
#undef KG_MONTH
#undef KG_DAY
#undef KG_TIME

// Compares integers of any length; returns -1, 0 or 1.
int CompareIntegers(const std::string& a, const std::string& b) {
  struct Parts {
    bool negative;
    std::string digits;  // Empty for zero.
  };
  const auto split = [](const std::string& text) {
    const std::size_t first = text.find_first_of("123456789");
    const bool zero = first == std::string::npos;
    return Parts{!zero && text[0] == '-', zero ? "" : text.substr(first)};
  };
  const Parts x = split(a), y = split(b);
  if (x.negative != y.negative) return x.negative ? -1 : 1;
  int order = x.digits.compare(y.digits);
  if (x.digits.size() != y.digits.size()) {
    order = x.digits.size() < y.digits.size() ? -1 : 1;
  }
  return x.negative ? -order : order;
}

bool IsInBounds(const LexicalRow& row, const std::string& text) {
  if (row.least && CompareIntegers(text, row.least) < 0) return false;
  return !row.most || CompareIntegers(text, row.most) <= 0;
}

// Checks the day of the month, which the pattern cannot express.
bool HasItsDay(const std::string& datatype, const std::string& text) {
  if (datatype != "date" && datatype.rfind("dateTime", 0) != 0) return true;
  const std::size_t dash = text.find('-', 1);
  const long year = std::atol(text.c_str());
  const int month = std::atoi(text.c_str() + dash + 1);
  const int day = std::atoi(text.c_str() + dash + 4);
  const bool leap = (year % 4 == 0 && year % 100 != 0) || year % 400 == 0;
  if (month == 2) return day <= (leap ? 29 : 28);
  const bool is_short = month == 4 || month == 6 || month == 9 || month == 11;
  return day <= (is_short ? 30 : 31);
}

}  // namespace

bool IsLexical(const Term& literal, kg_base::RegexCache& regexes) {
  const std::string xsd = kXsd;
  if (literal.datatype.compare(0, xsd.size(), xsd) != 0) return true;
  const std::string name = literal.datatype.substr(xsd.size());
  const LexicalRow* row = std::find_if(
      std::begin(kRows), std::end(kRows),
      [&](const LexicalRow& each) { return name == each.datatype; });
  if (row == std::end(kRows)) return true;
  const auto matches = regexes.Matches(literal.text, row->pattern, "");
  return matches && *matches && IsInBounds(*row, literal.text) &&
         HasItsDay(name, literal.text);
}

}  // namespace kg_core::shacl
