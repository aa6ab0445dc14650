#include "kg_base/raster/cf_time.h"

#include <cctype>
#include <cmath>
#include <cstdint>
#include <regex>

#include "kg_base/common/input_error.h"
#include "kg_base/common/text.h"

namespace kg_base {
namespace {

struct TimeUnit {
  const char* name;
  double seconds;
};
constexpr TimeUnit kUnits[] = {
    {"days", 86400.0},     {"day", 86400.0}, {"d", 86400.0},
    {"hours", 3600.0},     {"hour", 3600.0}, {"hrs", 3600.0},
    {"hr", 3600.0},        {"h", 3600.0},    {"minutes", 60.0},
    {"minute", 60.0},      {"mins", 60.0},   {"min", 60.0},
    {"seconds", 1.0},      {"second", 1.0},  {"secs", 1.0},
    {"sec", 1.0},          {"s", 1.0},       {"milliseconds", 1e-3},
    {"millisecond", 1e-3}, {"msecs", 1e-3},  {"msec", 1e-3},
    {"ms", 1e-3},
};

constexpr double kUnixEpochJulianDay = 2440588.0;  // Day number at noon.
constexpr std::size_t kMaxUnitsBytes = 200;

struct CalendarDate {
  std::int64_t year;
  std::int64_t month;
  std::int64_t day;
};

bool BeforeReform(const CalendarDate& date) {
  if (date.year != 1582) return date.year < 1582;
  return date.month < 10 || (date.month == 10 && date.day < 15);
}

// Fliegel and van Flandern, CACM 11 (1968), p. 657; for years after -4800.
double JulianDay(const CalendarDate& date, bool julian) {
  const std::int64_t a = (14 - date.month) / 12;
  const std::int64_t y = date.year + 4800 - a;
  const std::int64_t m = date.month + 12 * a - 3;
  const std::int64_t day = date.day + (153 * m + 2) / 5 + 365 * y + y / 4;
  return static_cast<double>(julian ? day - 32083
                                    : day - y / 100 + y / 400 - 32045);
}

[[noreturn]] void Refuse(const std::string& units) {
  throw InputError("time unit \"" + units.substr(0, kMaxUnitsBytes) +
                   "\" is not understood, expected for example \"hours since "
                   "2000-01-01 00:00:00\" (days, hours, minutes, seconds)");
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
      "\\s*([a-z]+)\\s+since\\s+(\\d{1,4})-(\\d{1,2})-(\\d{1,2})"
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
  CfTime time{0.0, 0.0};
  for (const TimeUnit& unit : kUnits) {
    if (match[1] == unit.name) time.unit_s = unit.seconds;
  }
  const CalendarDate date{std::stol(match[2]), std::stol(match[3]),
                          std::stol(match[4])};
  const bool sensible = date.month >= 1 && date.month <= 12 && date.day >= 1 &&
                        date.day <= 31 && Field(match[5]) <= 24.0 &&
                        Field(match[6]) < 60.0 && Field(match[7]) < 61.0;
  if (time.unit_s == 0.0 || !sensible) Refuse(units);
  // Calendar "standard" is Julian before the reform of 1582.
  const double day = JulianDay(date, !proleptic && BeforeReform(date));
  time.epoch_s = (day - kUnixEpochJulianDay) * 86400.0 +
                 Field(match[5]) * 3600.0 + Field(match[6]) * 60.0 +
                 Field(match[7]) - ZoneOffset_s(match);
  return time;
}

}  // namespace kg_base
