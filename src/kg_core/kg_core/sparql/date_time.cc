#include "kg_core/sparql/date_time.h"

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "kg_core/base/date_time.h"

namespace kg_core::sparql {
namespace {

// Reads from the front of `text`, remembering whether all fitted.
class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  bool ok() const { return ok_; }
  bool done() const { return ok_ && text_.empty(); }
  bool Skip(char c) {
    if (text_.empty() || text_[0] != c) return false;
    text_.remove_prefix(1);
    return true;
  }
  void Expect(char c) { ok_ = Skip(c) && ok_; }
  int Digits(std::size_t least, std::size_t most) {
    std::size_t n = 0;
    int value = 0;
    while (n < text_.size() && n < most && IsDigit(text_[n])) {
      value = value * 10 + (text_[n++] - '0');
    }
    ok_ = ok_ && n >= least;
    text_.remove_prefix(n);
    return value;
  }
  Decimal Second() {
    std::size_t n = 0;
    while (n < text_.size() && (IsDigit(text_[n]) || text_[n] == '.')) ++n;
    const std::optional<Decimal> value = ParseDecimal(text_.substr(0, n));
    ok_ = ok_ && value && n >= 2 && (n == 2 || (n > 3 && text_[2] == '.'));
    text_.remove_prefix(n);
    return value.value_or(Decimal{});
  }

 private:
  static bool IsDigit(char c) { return c >= '0' && c <= '9'; }

  std::string_view text_;
  bool ok_ = true;
};

void ReadDay(Reader* reader, DateTime* value) {
  const bool negative = reader->Skip('-');
  value->year = reader->Digits(4, 9) * (negative ? -1 : 1);
  reader->Expect('-');
  value->month = reader->Digits(2, 2);
  reader->Expect('-');
  value->day = reader->Digits(2, 2);
}

void ReadZone(Reader* reader, DateTime* value) {
  if (reader->Skip('Z')) {
    value->zone_min = 0;
    return;
  }
  const bool east = reader->Skip('+');
  if (!east && !reader->Skip('-')) return;
  const int hours = reader->Digits(2, 2);
  reader->Expect(':');
  const int minutes = hours * 60 + reader->Digits(2, 2);
  value->zone_min = east ? minutes : -minutes;
}

bool InRange(const DateTime& value) {
  if (value.month < 1 || value.month > 12 || value.day < 1) return false;
  if (value.day > DaysInMonth(value.year, value.month)) return false;
  const bool midnight = value.hour == 24 && value.minute == 0 &&
                        Compare(value.second, Decimal{}) == 0;
  return (value.hour < 24 || midnight) && value.minute < 60 &&
         Compare(value.second, Decimal{60, 0}) < 0 &&
         std::abs(value.zone_min.value_or(0)) <= 14 * 60;
}

}  // namespace

std::optional<DateTime> ParseDateTime(std::string_view text) {
  Reader reader(text);
  DateTime value;
  ReadDay(&reader, &value);
  reader.Expect('T');
  value.hour = reader.Digits(2, 2);
  reader.Expect(':');
  value.minute = reader.Digits(2, 2);
  reader.Expect(':');
  value.second = reader.Second();
  ReadZone(&reader, &value);
  if (!reader.done() || !InRange(value)) return std::nullopt;
  return value;
}

std::optional<DateTime> ParseDate(std::string_view text) {
  Reader reader(text);
  DateTime value;
  ReadDay(&reader, &value);
  ReadZone(&reader, &value);
  if (!reader.done() || !InRange(value)) return std::nullopt;
  return value;
}

int Compare(const DateTime& a, const DateTime& b) {
  const auto minutes = [](const DateTime& t) {
    return (DaysFromCivil(t.year, t.month, t.day) * 24 + t.hour) * 60 +
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
