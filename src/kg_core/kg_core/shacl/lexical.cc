#include "kg_core/shacl/lexical.h"

#include <algorithm>
#include <cstdlib>
#include <string>

#include "kg_core/rdf/namespaces.h"
#include "kg_core/sparql/values.h"

namespace kg_core::shacl {
namespace {

#define KG_ZONE "(Z|[+-](0[0-9]|1[0-3]):[0-5][0-9]|[+-]14:00)?$"
#define KG_YEAR "^-?([1-9][0-9]{3,}|0[0-9]{3})"
#define KG_MONTH "(0[1-9]|1[0-2])"
#define KG_DAY "(0[1-9]|[12][0-9]|3[01])"
#define KG_TIME \
  "(([01][0-9]|2[0-3]):[0-5][0-9]:[0-5][0-9](\\.[0-9]+)?|24:00:00(\\.0+)?)"

struct LexicalRow {
  const char* datatype;  // Local name in xsd:.
  const char* pattern;   // A regular expression of XPath.
};
// Numbers are those that have a value (rdf/term.h).
constexpr LexicalRow kRows[] = {
    {"boolean", "^(true|false|0|1)$"},
    {"dateTime", KG_YEAR "-" KG_MONTH "-" KG_DAY "T" KG_TIME KG_ZONE},
    {"dateTimeStamp", KG_YEAR "-" KG_MONTH "-" KG_DAY "T" KG_TIME
                              "(Z|[+-](0[0-9]|1[0-3]):[0-5][0-9]|[+-]14:00)$"},
    {"date", KG_YEAR "-" KG_MONTH "-" KG_DAY KG_ZONE},
    {"time", "^" KG_TIME KG_ZONE},
    {"gYear", KG_YEAR KG_ZONE},
    {"gYearMonth", KG_YEAR "-" KG_MONTH KG_ZONE},
    {"gMonth", "^--" KG_MONTH KG_ZONE},
    {"gDay", "^---" KG_DAY KG_ZONE},
    {"gMonthDay", "^--" KG_MONTH "-" KG_DAY KG_ZONE},
    {"duration",
     "^-?P([0-9]+Y)?([0-9]+M)?([0-9]+D)?"
     "(T([0-9]+H)?([0-9]+M)?([0-9]+(\\.[0-9]+)?S)?)?$"},
    {"dayTimeDuration",
     "^-?P([0-9]+D)?(T([0-9]+H)?([0-9]+M)?([0-9]+(\\.[0-9]+)?S)?)?$"},
    {"yearMonthDuration", "^-?P([0-9]+Y)?([0-9]+M)?$"},
    {"hexBinary", "^([0-9a-fA-F]{2})*$"},
    {"language", "^[a-zA-Z]{1,8}(-[a-zA-Z0-9]{1,8})*$"},
    {"anyURI", "^[^\\s<>\"{}|\\\\^`]*$"},
};

#undef KG_ZONE
#undef KG_YEAR
#undef KG_MONTH
#undef KG_DAY
#undef KG_TIME

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

// Checks that a part follows P and T, which the pattern cannot express.
bool HasItsParts(const std::string& datatype, const std::string& text) {
  const bool is_duration = datatype == "duration" ||
                           datatype == "dayTimeDuration" ||
                           datatype == "yearMonthDuration";
  return !is_duration || (text.back() != 'P' && text.back() != 'T');
}

}  // namespace

bool IsLexical(const Term& literal, kg_base::RegexCache& regexes) {
  const std::string xsd = kXsd;
  if (literal.datatype.compare(0, xsd.size(), xsd) != 0) return true;
  if (sparql::IsNumericType(literal.datatype)) {
    return NumericValue(literal).has_value();
  }
  const std::string name = literal.datatype.substr(xsd.size());
  const LexicalRow* row = std::find_if(
      std::begin(kRows), std::end(kRows),
      [&](const LexicalRow& each) { return name == each.datatype; });
  if (row == std::end(kRows)) return true;
  const auto matches = regexes.Matches(literal.text, row->pattern, "");
  return matches && *matches && HasItsDay(name, literal.text) &&
         HasItsParts(name, literal.text);
}

}  // namespace kg_core::shacl
