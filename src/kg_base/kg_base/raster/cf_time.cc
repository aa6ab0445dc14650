#include "kg_base/raster/cf_time.h"

#include <cctype>
#include <cmath>
#include <optional>
#include <regex>
#include <tuple>

#include "kg_base/common/date_time.h"
#include "kg_base/common/input_error.h"
#include "kg_base/common/text.h"
#include "kg_base/raster/unit_conversion.h"

namespace kg_base {
namespace {

constexpr std::size_t kMaxUnitsBytes = 200;

// A date in one of the two calendars.
struct CalendarDate {
  int year;
  int month;
  int day;
  bool is_julian;

  bool IsValid() const {
    if (month < 1 || month > 12 || day < 1) return false;
    return day <= (is_julian ? DaysInJulianMonth(year, month)
                             : DaysInMonth(year, month));
  }
  // Days since 1970-01-01 of the Gregorian calendar.
  double Days() const {
    return static_cast<double>(is_julian ? DaysFromJulian(year, month, day)
                                         : DaysFromCivil(year, month, day));
  }
};

bool IsBeforeReform(int year, int month, int day) {
  return std::tie(year, month, day) < std::make_tuple(1582, 10, 15);
}

// Calendar "standard" is Julian before the reform of 1582.
CalendarDate ReadDate(const std::smatch& match, bool is_proleptic) {
  const int year = std::stoi(match[2]);
  const int month = std::stoi(match[3]);
  const int day = std::stoi(match[4]);
  return {year, month, day, !is_proleptic && IsBeforeReform(year, month, day)};
}

[[noreturn]] void Refuse(const std::string& units) {
  throw InputError("time unit \"" + units.substr(0, kMaxUnitsBytes) +
                   "\" is not understood, expected for example \"hours since "
                   "2000-01-01 00:00:00\" (days, hours, minutes, seconds)");
}

// UDUNITS gives months and years their mean length.
bool HasNoFixedLength(const std::string& unit) {
  return unit.find("month") != std::string::npos ||
         unit.find("year") != std::string::npos || unit == "yr" ||
         unit == "yrs" || unit == "a";
}

double UnitSeconds(const std::string& unit, const std::string& units) {
  if (HasNoFixedLength(unit)) Refuse(units);
  const std::optional<UnitScale> scale = ConvertUnit(unit, "s");
  if (!scale || !(scale->scale > 0.0) || scale->offset != 0.0) Refuse(units);
  return scale->scale;
}

double Field(const std::ssub_match& text) {
  return text.matched && text.length() > 0 ? std::stod(text.str()) : 0.0;
}

double ZoneOffset_s(const std::smatch& match) {
  const double sign = match[8] == "-" ? -1.0 : 1.0;
  return sign * (3600.0 * Field(match[9]) + 60.0 * Field(match[10]));
}

}  // namespace

CfTime ParseCfTime(const std::string& units, const std::string& calendar) {
  // Groups: 1 unit; 2-4 date; 5-7 time of day, each part optional; 8-10 zone.
  static const std::regex kPattern(
      "\\s*([a-z0-9.]+(?: "
      "[a-z0-9.]+)*)\\s+since\\s+(\\d{1,4})-(\\d{1,2})-(\\d{1,2})"
      "(?:[t\\s]\\s*(\\d{1,2})(?::(\\d{1,2})(?::(\\d{1,2}(?:\\.\\d*)?))?)?)?"
      "\\s*(?:z|utc|gmt|([+-])(\\d{1,2})(?::?(\\d{2}))?)?\\s*");
  const std::string kind = ToLowerAscii(calendar);
  const bool proleptic = kind == "proleptic_gregorian";
  if (!proleptic && !kind.empty() && kind != "standard" &&
      kind != "gregorian") {
    throw InputError("calendar \"" + calendar.substr(0, kMaxUnitsBytes) +
                     "\" is not understood, expected standard, gregorian or "
                     "proleptic_gregorian");
  }
  const std::string text = ToLowerAscii(units);
  std::smatch match;
  // Check the length first: std::regex recurses once per character.
  if (text.size() > kMaxUnitsBytes ||
      !std::regex_match(text, match, kPattern)) {
    Refuse(units);
  }
  CfTime time;
  time.unit_s =
      UnitSeconds(std::string(StripAsciiSpace(match[1].str())), units);
  const CalendarDate date = ReadDate(match, proleptic);
  const bool sensible = date.IsValid() && Field(match[5]) <= 24.0 &&
                        Field(match[6]) < 60.0 && Field(match[7]) < 61.0;
  if (!sensible) Refuse(units);
  time.epoch_s = date.Days() * 86400.0 + Field(match[5]) * 3600.0 +
                 Field(match[6]) * 60.0 + Field(match[7]) - ZoneOffset_s(match);
  return time;
}

}  // namespace kg_base
