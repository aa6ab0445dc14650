#include "kg_core/sparql/xsd_date_time.h"

#include <cstdio>
#include <ctime>

#include "kg_base/common/date_time.h"

namespace kg_core::sparql {
namespace {

std::optional<DateTime> ToDateTime(
    const std::optional<kg_base::DateTimeParts>& parts) {
  if (!parts) return std::nullopt;
  // nullopt if it has more digits than a Decimal can hold.
  const std::optional<kg_base::Decimal> second =
      kg_base::ParseDecimal(parts->second);
  if (!second) return std::nullopt;
  return DateTime{parts->year,   parts->month, parts->day,     parts->hour,
                  parts->minute, *second,      parts->zone_min};
}

}  // namespace

std::optional<DateTime> ParseDateTime(std::string_view text) {
  return ToDateTime(kg_base::ReadDateTimeParts(text));
}

std::optional<DateTime> ParseDate(std::string_view text) {
  return ToDateTime(kg_base::ReadDateParts(text));
}

int Compare(const DateTime& a, const DateTime& b) {
  const auto minutes = [](const DateTime& t) {
    return (kg_base::DaysFromCivil(t.year, t.month, t.day) * 24 + t.hour) * 60 +
           t.minute - t.zone_min.value_or(0);
  };
  const std::int64_t left = minutes(a);
  const std::int64_t right = minutes(b);
  if (left != right) return left < right ? -1 : 1;
  return Compare(a.second, b.second);
}

std::string FormatUtc(std::int64_t unix_ms) {
  const std::time_t seconds = static_cast<std::time_t>(unix_ms / 1000);
  std::tm parts{};
  gmtime_r(&seconds, &parts);
  char text[64];
  std::snprintf(text, sizeof text, "%04d-%02d-%02dT%02d:%02d:%02d.%03dZ",
                parts.tm_year + 1900, parts.tm_mon + 1, parts.tm_mday,
                parts.tm_hour, parts.tm_min, parts.tm_sec,
                static_cast<int>(unix_ms % 1000));
  return text;
}

}  // namespace kg_core::sparql
