// XML Schema dates and durations in seconds.
//
//   ParseDateTime("2026-03-01T06:00:00-06:00")  ==  1772366400.0  (12:00 UTC)
//   ParseDuration("P1DT2H30M")                  ==  95400.0
//
// Unix time: SI seconds since 1970-01-01T00:00:00Z without leap seconds, in the
// proleptic Gregorian calendar. A double holds it to 0.24 us in this century.
// Source: https://www.w3.org/TR/xmlschema11-2/#dateTime, #duration.

#ifndef KG_BASE_COMMON_DATE_TIME_H_
#define KG_BASE_COMMON_DATE_TIME_H_

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace kg_base {

// The parts of an xsd:dateTime or an xsd:date as written.
struct DateTimeParts {
  int year = 0;
  int month = 1;
  int day = 1;
  int hour = 0;  // 24 only in 24:00:00.
  int minute = 0;
  std::string_view second = "00";  // Two digits, optional "." and fraction.
  std::optional<int> zone_min;     // Minutes east of UTC.
};

// Nullopt if `text` is not such a value. The result refers to `text`.
std::optional<DateTimeParts> ReadDateTimeParts(std::string_view text);
std::optional<DateTimeParts> ReadDateParts(std::string_view text);

// The Unix time of an xsd:dateTime; UTC if it names no time zone. Throws
// InputError.
double ParseDateTime(std::string_view text);

// The xsd:dateTime of a Unix time, in UTC, rounded to microseconds, without
// trailing zeros: "2026-03-01T12:00:00Z". The year lies in 0..9999; anything
// else, or NaN, throws std::invalid_argument.
std::string FormatDateTime(double unix_s);

// The seconds of an xsd:dayTimeDuration, or of an xsd:duration without years
// and months, which have no fixed length. Throws InputError.
double ParseDuration(std::string_view text);

// Days since 1970-01-01; the year is counted from March, so that a leap day is
// its last. http://howardhinnant.github.io/date_algorithms.html#days_from_civil
std::int64_t DaysFromCivil(std::int64_t year, int month, int day);
// The same for a date of the Julian calendar.
std::int64_t DaysFromJulian(std::int64_t year, int month, int day);

// Proleptic Gregorian and Julian calendar; month in 1..12.
int DaysInMonth(std::int64_t year, int month);
int DaysInJulianMonth(std::int64_t year, int month);

}  // namespace kg_base

#endif  // KG_BASE_COMMON_DATE_TIME_H_
