#include "kg_core/facts/literals.h"

#include <string>

#include "kg_base/common/date_time.h"
#include "kg_base/common/input_error.h"
#include "kg_core/rdf/namespaces.h"

namespace kg_core {
namespace {

bool IsXsd(const Term& term, std::string_view name) {
  return term.is_literal() && term.datatype == kXsd + std::string(name);
}

// Calls `parse` and converts its InputError to nullopt.
std::optional<double> Value(double (*parse)(std::string_view),
                            const Term& term) {
  try {
    return parse(term.text);
  } catch (const kg_base::InputError&) {
    return std::nullopt;
  }
}

bool HasNumber(const Term& term) { return NumericValue(term).has_value(); }
bool HasTime(const Term& term) { return UnixSeconds(term).has_value(); }
bool HasDuration(const Term& term) { return DurationSeconds(term).has_value(); }
bool HasTruth(const Term& term) { return BooleanValue(term).has_value(); }

// Datatypes of XML Schema whose lexical forms are checked.
struct LexicalForm {
  const char* datatype;
  bool (*is_well_formed)(const Term&);
};
constexpr LexicalForm kLexical[] = {
    {"integer", HasNumber},
    {"decimal", HasNumber},
    {"double", HasNumber},
    {"float", HasNumber},
    {"int", HasNumber},
    {"long", HasNumber},
    {"short", HasNumber},
    {"byte", HasNumber},
    {"nonNegativeInteger", HasNumber},
    {"positiveInteger", HasNumber},
    {"nonPositiveInteger", HasNumber},
    {"negativeInteger", HasNumber},
    {"unsignedInt", HasNumber},
    {"unsignedLong", HasNumber},
    {"unsignedShort", HasNumber},
    {"unsignedByte", HasNumber},
    {"boolean", HasTruth},
    {"dateTime", HasTime},
    {"duration", HasDuration},
    {"dayTimeDuration", HasDuration},
};

}  // namespace

bool IsWellFormed(const Term& literal) {
  for (const LexicalForm& row : kLexical) {
    if (IsXsd(literal, row.datatype)) return row.is_well_formed(literal);
  }
  return true;
}

std::optional<double> UnixSeconds(const Term& term) {
  if (!IsXsd(term, "dateTime")) return std::nullopt;
  return Value(kg_base::ParseDateTime, term);
}

std::optional<double> DurationSeconds(const Term& term) {
  if (!IsXsd(term, "duration") && !IsXsd(term, "dayTimeDuration")) {
    return std::nullopt;
  }
  return Value(kg_base::ParseDuration, term);
}

std::optional<bool> BooleanValue(const Term& term) {
  if (!IsXsd(term, "boolean")) return std::nullopt;
  if (term.text == "true" || term.text == "1") return true;
  if (term.text == "false" || term.text == "0") return false;
  return std::nullopt;
}

Term DateTimeLiteral(double unix_s) {
  return Literal(kg_base::FormatDateTime(unix_s),
                 std::string(kXsd) + "dateTime");
}

}  // namespace kg_core
