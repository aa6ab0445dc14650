#include "kg_base/common/date_time.h"

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <stdexcept>

#include "absl/strings/charconv.h"
#include "kg_base/common/input_error.h"
#include "kg_base/common/text.h"

namespace kg_base {
namespace {

constexpr std::int64_t kSecondsPerDay = 86400;
constexpr int kDaysInMonth[] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};

// Days since March 1, in a year that begins there.
int DayOfYearFromMarch(int month, int day) {
  return (153 * (month + (month > 2 ? -3 : 9)) + 2) / 5 + day - 1;
}

struct CivilDay {
  std::int64_t year;
  int month, day;
};

// The inverse of DaysFromCivil, same source.
CivilDay CivilFromDays(std::int64_t days) {
  days += 719468;
  const std::int64_t era = (days >= 0 ? days : days - 146096) / 146097;
  const std::int64_t day_of_era = days - era * 146097;
  const std::int64_t year_of_era = (day_of_era - day_of_era / 1460 +
                                    day_of_era / 36524 - day_of_era / 146096) /
                                   365;
  const std::int64_t day_of_year =
      day_of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
  const int month_from_march = static_cast<int>((5 * day_of_year + 2) / 153);
  const int month = month_from_march + (month_from_march < 10 ? 3 : -9);
  return {era * 400 + year_of_era + (month <= 2), month,
          static_cast<int>(day_of_year - (153 * month_from_march + 2) / 5 + 1)};
}

bool IsDigit(char c) { return c >= '0' && c <= '9'; }

double ToDouble(const std::string& digits) {
  double value = 0.0;
  absl::from_chars(digits.data(), digits.data() + digits.size(), value);
  return value;
}

// Reads a duration from left to right; errors state the expected whole form.
class Cursor {
 public:
  Cursor(std::string_view text, const char* expected)
      : text_(text), rest_(text), expected_(expected) {}

  bool done() const { return rest_.empty(); }
  char next() const { return rest_.empty() ? '\0' : rest_[0]; }

  bool Take(char c) {
    if (next() != c) return false;
    rest_.remove_prefix(1);
    return true;
  }
  void Need(char c) {
    if (!Take(c)) Refuse();
  }
  void NeedEnd() {
    if (!done()) Refuse();
  }
  std::string_view TakeDigits() {
    std::size_t n = 0;
    while (n < rest_.size() && IsDigit(rest_[n])) ++n;
    const std::string_view digits = rest_.substr(0, n);
    rest_.remove_prefix(n);
    return digits;
  }
  // Fraction after a '.', in [0, 1); 0 without a '.'.
  double TakeFraction() {
    if (!Take('.')) return 0.0;
    const std::string_view digits = TakeDigits();
    if (digits.empty()) Refuse();
    return ToDouble("0." + std::string(digits));
  }
  [[noreturn]] void Refuse() const {
    throw InputError("'" + std::string(FirstCharacters(text_, 64)) +
                     "' is not a " + expected_);
  }

 private:
  const std::string_view text_;
  std::string_view rest_;
  const char* const expected_;
};

// Reads the parts of a date from left to right and remembers whether all of
// them were well-formed.
class PartsReader {
 public:
  explicit PartsReader(std::string_view text) : rest_(text) {}

  bool done() const { return ok_ && rest_.empty(); }
  bool Skip(char c) {
    if (rest_.empty() || rest_[0] != c) return false;
    rest_.remove_prefix(1);
    return true;
  }
  void Expect(char c) { ok_ = Skip(c) && ok_; }

  void ReadDay(DateTimeParts* parts) {
    const bool negative = Skip('-');
    const std::string_view digits = Digits();
    // 4 to 9 digits, more than 4 only as needed: 0044 and 12026, not 02026.
    const bool is_padded = digits.size() > 4 && digits[0] == '0';
    ok_ = ok_ && digits.size() >= 4 && digits.size() <= 9 && !is_padded;
    if (!ok_) return;
    const int year = std::stoi(std::string(digits));
    parts->year = negative ? -year : year;
    Expect('-');
    parts->month = Two(1, 12);
    Expect('-');
    parts->day = Two(1, ok_ ? DaysInMonth(parts->year, parts->month) : 31);
  }

  void ReadTime(DateTimeParts* parts) {
    parts->hour = Two(0, 24);
    Expect(':');
    const bool is_midnight = parts->hour == 24;
    parts->minute = Two(0, is_midnight ? 0 : 59);
    Expect(':');
    const std::string_view begin = rest_;
    Two(0, is_midnight ? 0 : 59);
    if (Skip('.')) {
      const std::string_view digits = Digits();
      ok_ = ok_ && !digits.empty();
      // 24:00:00 has no fraction other than zeros.
      const bool is_zero =
          digits.find_first_not_of('0') == std::string_view::npos;
      ok_ = ok_ && (!is_midnight || is_zero);
    }
    parts->second = begin.substr(0, begin.size() - rest_.size());
  }

  void ReadZone(DateTimeParts* parts) {
    if (rest_.empty()) return;
    if (Skip('Z')) {
      parts->zone_min = 0;
      return;
    }
    const bool is_west = Skip('-');
    if (!is_west) Expect('+');
    const int hour = Two(0, 14);
    Expect(':');
    const int minutes = hour * 60 + Two(0, hour == 14 ? 0 : 59);
    parts->zone_min = is_west ? -minutes : minutes;
  }

 private:
  std::string_view Digits() {
    std::size_t n = 0;
    while (n < rest_.size() && IsDigit(rest_[n])) ++n;
    const std::string_view digits = rest_.substr(0, n);
    rest_.remove_prefix(n);
    return digits;
  }
  // Exactly two digits, in [min, max]; `min` if there are none.
  int Two(int min, int max) {
    const std::string_view digits = Digits();
    ok_ = ok_ && digits.size() == 2;
    if (!ok_) return min;
    const int value = (digits[0] - '0') * 10 + (digits[1] - '0');
    ok_ = value >= min && value <= max;
    return ok_ ? value : min;
  }

  std::string_view rest_;
  bool ok_ = true;
};

// Reads one part such as "12H" of a duration, with a unit from `units`; each
// unit may occur once, in order. Returns its length [s].
double TakePart(Cursor* cursor, std::string_view* units) {
  const std::string_view digits = cursor->TakeDigits();
  if (digits.empty()) cursor->Refuse();
  const bool has_point = cursor->next() == '.';
  const double fraction = cursor->TakeFraction();
  const std::size_t place = units->find(cursor->next());
  const bool known = !cursor->done() && place != std::string_view::npos;
  if (!known || (has_point && cursor->next() != 'S')) cursor->Refuse();
  const char unit = cursor->next();
  cursor->Take(unit);
  units->remove_prefix(place + 1);
  const double count = ToDouble(std::string(digits)) + fraction;
  const std::int64_t unit_s = unit == 'D'   ? kSecondsPerDay
                              : unit == 'H' ? 3600
                              : unit == 'M' ? 60
                                            : 1;
  return count * static_cast<double>(unit_s);
}

}  // namespace

std::int64_t DaysFromCivil(std::int64_t year, int month, int day) {
  year -= month <= 2;
  const std::int64_t era = (year >= 0 ? year : year - 399) / 400;
  const std::int64_t year_of_era = year - era * 400;
  const std::int64_t day_of_era = year_of_era * 365 + year_of_era / 4 -
                                  year_of_era / 100 +
                                  DayOfYearFromMarch(month, day);
  return era * 146097 + day_of_era - 719468;
}

std::int64_t DaysFromJulian(std::int64_t year, int month, int day) {
  year -= month <= 2;
  const std::int64_t era = (year >= 0 ? year : year - 3) / 4;
  const std::int64_t year_of_era = year - era * 4;
  // 0000-03-01 is two days earlier than in the Gregorian calendar.
  return era * 1461 + year_of_era * 365 + DayOfYearFromMarch(month, day) -
         719470;
}

int DaysInMonth(std::int64_t year, int month) {
  const bool leap = year % 4 == 0 && (year % 100 != 0 || year % 400 == 0);
  return month == 2 && leap ? 29 : kDaysInMonth[month - 1];
}

int DaysInJulianMonth(std::int64_t year, int month) {
  return month == 2 && year % 4 == 0 ? 29 : kDaysInMonth[month - 1];
}

std::optional<DateTimeParts> ReadDateTimeParts(std::string_view text) {
  PartsReader reader(text);
  DateTimeParts parts;
  reader.ReadDay(&parts);
  reader.Expect('T');
  reader.ReadTime(&parts);
  reader.ReadZone(&parts);
  if (!reader.done()) return std::nullopt;
  return parts;
}

std::optional<DateTimeParts> ReadDateParts(std::string_view text) {
  PartsReader reader(text);
  DateTimeParts parts;
  reader.ReadDay(&parts);
  reader.ReadZone(&parts);
  if (!reader.done()) return std::nullopt;
  return parts;
}

double ParseDateTime(std::string_view text) {
  const std::optional<DateTimeParts> parts = ReadDateTimeParts(text);
  if (!parts) {
    throw InputError("'" + std::string(FirstCharacters(text, 64)) +
                     "' is not an xsd:dateTime like 2026-03-01T12:00:00Z");
  }
  const std::string_view second = parts->second;
  const int whole_second = (second[0] - '0') * 10 + (second[1] - '0');
  const double fraction_s =
      second.size() > 2 ? ToDouble("0" + std::string(second.substr(2))) : 0.0;
  const std::int64_t minutes = std::int64_t{60} * parts->hour + parts->minute -
                               parts->zone_min.value_or(0);
  const std::int64_t whole_s =
      DaysFromCivil(parts->year, parts->month, parts->day) * kSecondsPerDay +
      std::int64_t{60} * minutes + whole_second;
  return static_cast<double>(whole_s) + fraction_s;
}

std::string FormatDateTime(double unix_s) {
  constexpr double kFirst = -62167219200.0;  // 0000-01-01T00:00:00Z
  constexpr double kEnd = 253402300800.0;    // 10000-01-01T00:00:00Z
  if (!(unix_s >= kFirst && unix_s < kEnd - 1e-3)) {
    throw std::invalid_argument("time outside the years 0 to 9999");
  }
  const double whole = std::floor(unix_s);
  std::int64_t seconds = static_cast<std::int64_t>(whole);
  std::int64_t micros = std::llround((unix_s - whole) * 1e6);
  seconds += micros / 1000000;
  micros %= 1000000;
  const std::int64_t time_s =
      (seconds % kSecondsPerDay + kSecondsPerDay) % kSecondsPerDay;
  const CivilDay day = CivilFromDays((seconds - time_s) / kSecondsPerDay);
  char text[64];
  std::snprintf(text, sizeof(text), "%04d-%02d-%02dT%02d:%02d:%02d.%06d",
                static_cast<int>(day.year), day.month, day.day,
                static_cast<int>(time_s / 3600),
                static_cast<int>(time_s / 60 % 60),
                static_cast<int>(time_s % 60), static_cast<int>(micros));
  std::string trimmed = text;
  trimmed.erase(trimmed.find_last_not_of('0') + 1);
  if (trimmed.back() == '.') trimmed.pop_back();
  return micros == 0 ? std::string(text, 19) + "Z" : trimmed + "Z";
}

double ParseDuration(std::string_view text) {
  Cursor cursor(text,
                "duration of days, hours, minutes and seconds like P1DT12H");
  const double sign = cursor.Take('-') ? -1.0 : 1.0;
  cursor.Need('P');
  if (cursor.done()) cursor.Refuse();
  double total_s = 0.0;
  std::string_view day_units = "D";
  while (!cursor.done() && cursor.next() != 'T') {
    total_s += TakePart(&cursor, &day_units);
  }
  if (cursor.done()) return sign * total_s;
  cursor.Need('T');
  if (cursor.done()) cursor.Refuse();
  std::string_view time_units = "HMS";
  while (!cursor.done()) total_s += TakePart(&cursor, &time_units);
  return sign * total_s;
}

}  // namespace kg_base
