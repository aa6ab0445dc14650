// xsd:dateTime and xsd:date values.
// https://www.w3.org/TR/xmlschema11-2/#dateTime
//
// A value without a time zone is taken as UTC (the implicit time zone of
// https://www.w3.org/TR/xpath-functions/#func-implicit-timezone): all facts of
// this project are UTC, so every pair of values is ordered.

#ifndef KG_CORE_SPARQL_XSD_DATE_TIME_H_
#define KG_CORE_SPARQL_XSD_DATE_TIME_H_

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "kg_base/text/decimal.h"

namespace kg_core::sparql {

struct DateTime {
  int year = 0;
  int month = 1;
  int day = 1;
  int hour = 0;
  int minute = 0;
  kg_base::Decimal second;
  std::optional<int> zone_min;  // Minutes east of UTC.
};

std::optional<DateTime> ParseDateTime(std::string_view text);
std::optional<DateTime> ParseDate(std::string_view text);
int Compare(const DateTime& a, const DateTime& b);  // -1, 0, 1.

// "2020-11-01T12:00:00.000Z" for a count of milliseconds since 1970.
std::string FormatUtc(std::int64_t unix_ms);

}  // namespace kg_core::sparql

#endif  // KG_CORE_SPARQL_XSD_DATE_TIME_H_
