#include "kg_base/text/decimal.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace kg_base {
namespace {

using Wide = __int128;

constexpr int kMaxScale = 36;
constexpr int kDivisionScale = 18;

bool MultiplyByTen(Wide* value) {
  return !__builtin_mul_overflow(*value, Wide{10}, value);
}

std::optional<Decimal> Rescale(Decimal value, int scale) {
  for (; value.scale < scale; ++value.scale) {
    if (!MultiplyByTen(&value.digits)) return std::nullopt;
  }
  return value;
}

Decimal Trim(Decimal value) {
  while (value.scale > 0 && value.digits % 10 == 0) {
    value.digits /= 10;
    --value.scale;
  }
  return value;
}

Wide PowerOfTen(int exponent) {
  Wide power = 1;
  for (int i = 0; i < exponent; ++i) power *= 10;
  return power;
}

std::string FormatDigits(Wide value) {
  std::string digits;
  do {
    const int digit = static_cast<int>(value % 10);
    digits.push_back(static_cast<char>('0' + std::abs(digit)));
    value /= 10;
  } while (value != 0);
  std::reverse(digits.begin(), digits.end());
  return digits;
}

// Compares numerator / denominator with `b`, all in [0, 1), by their binary
// digits, of which a double has finitely many.
int CompareFractions(Wide numerator, Wide denominator, double b) {
  while (numerator > 0 && b > 0) {
    numerator *= 2;
    b *= 2;
    const bool a_digit = numerator >= denominator;
    const bool b_digit = b >= 1;
    if (a_digit != b_digit) return a_digit ? 1 : -1;
    if (a_digit) {
      numerator -= denominator;
      b -= 1;
    }
  }
  return numerator > 0 ? 1 : b > 0 ? -1 : 0;
}

}  // namespace

std::optional<Decimal> ParseDecimal(std::string_view text) {
  bool negative = false;
  if (!text.empty() && (text[0] == '+' || text[0] == '-')) {
    negative = text[0] == '-';
    text.remove_prefix(1);
  }
  Decimal value;
  bool digit_seen = false;
  bool point_seen = false;
  for (const char c : text) {
    if (c == '.' && !point_seen) {
      point_seen = true;
      continue;
    }
    if (c < '0' || c > '9') return std::nullopt;
    digit_seen = true;
    // Fraction digits beyond the scale are truncated.
    if (point_seen && value.scale == kMaxScale) continue;
    if (!MultiplyByTen(&value.digits)) return std::nullopt;
    if (__builtin_add_overflow(value.digits, Wide{c - '0'}, &value.digits)) {
      return std::nullopt;
    }
    if (point_seen) ++value.scale;
  }
  if (!digit_seen) return std::nullopt;
  if (negative) value.digits = -value.digits;
  return Trim(value);
}

std::string ToString(const Decimal& value) {
  const Decimal trimmed = Trim(value);
  std::string text = FormatDigits(trimmed.digits);
  if (trimmed.scale > 0) {
    const auto scale = static_cast<std::size_t>(trimmed.scale);
    if (text.size() <= scale) text.insert(0, scale + 1 - text.size(), '0');
    text.insert(text.size() - scale, ".");
  }
  return trimmed.digits < 0 ? "-" + text : text;
}

double ToDouble(const Decimal& value) {
  return std::strtod(ToString(value).c_str(), nullptr);
}

std::optional<Decimal> FromDouble(double value) {
  if (!std::isfinite(value)) return std::nullopt;
  // The shortest decimal that reads back as `value`: 17 digits always do.
  for (int precision = 15; precision <= 17; ++precision) {
    char text[64];
    std::snprintf(text, sizeof text, "%.*e", precision - 1, value);
    if (precision < 17 && std::strtod(text, nullptr) != value) continue;
    const std::string_view view(text);
    const std::size_t e = view.find('e');
    std::optional<Decimal> result = ParseDecimal(view.substr(0, e));
    const int exponent = std::atoi(text + e + 1);
    if (!result) return std::nullopt;
    result->scale -= exponent;
    if (result->scale > kMaxScale) return Decimal{};
    for (; result->scale < 0; ++result->scale) {
      if (!MultiplyByTen(&result->digits)) return std::nullopt;
    }
    return Trim(*result);
  }
  return std::nullopt;
}

std::optional<Decimal> Add(const Decimal& a, const Decimal& b) {
  const int scale = std::max(a.scale, b.scale);
  const std::optional<Decimal> x = Rescale(a, scale);
  const std::optional<Decimal> y = Rescale(b, scale);
  Decimal sum{0, scale};
  if (!x || !y || __builtin_add_overflow(x->digits, y->digits, &sum.digits)) {
    return std::nullopt;
  }
  return Trim(sum);
}

std::optional<Decimal> Subtract(const Decimal& a, const Decimal& b) {
  return Add(a, Decimal{-b.digits, b.scale});
}

std::optional<Decimal> Multiply(const Decimal& a, const Decimal& b) {
  const Decimal x = Trim(a);
  const Decimal y = Trim(b);
  Decimal product{0, x.scale + y.scale};
  if (__builtin_mul_overflow(x.digits, y.digits, &product.digits) ||
      product.scale > kMaxScale) {
    return std::nullopt;
  }
  return Trim(product);
}

std::optional<Decimal> Divide(const Decimal& a, const Decimal& b) {
  if (b.digits == 0) return std::nullopt;
  const Decimal divisor = Trim(b);
  Decimal quotient{0, 0};
  Wide rest = a.digits % divisor.digits;
  quotient.digits = a.digits / divisor.digits;
  quotient.scale = a.scale - divisor.scale;
  while (quotient.scale < 0 || (rest != 0 && quotient.scale < kDivisionScale)) {
    if (!MultiplyByTen(&rest) || !MultiplyByTen(&quotient.digits)) break;
    quotient.digits += rest / divisor.digits;
    rest %= divisor.digits;
    ++quotient.scale;
  }
  if (quotient.scale < 0) return std::nullopt;
  return Trim(quotient);
}

int Compare(const Decimal& a, const Decimal& b) {
  const std::optional<Decimal> x = Rescale(a, b.scale);
  const std::optional<Decimal> y = Rescale(b, a.scale);
  if (!x || !y) {
    const double left = ToDouble(a);
    const double right = ToDouble(b);
    return left < right ? -1 : left > right ? 1 : 0;
  }
  return x->digits < y->digits ? -1 : x->digits > y->digits ? 1 : 0;
}

int CompareWithDouble(const Decimal& a, double b) {
  if (b < 0) return -CompareWithDouble(Decimal{-a.digits, a.scale}, -b);
  // Digits are less than 2^127.
  if (a.digits < 0 || b >= 0x1p127) return -1;
  const double b_whole = std::floor(b);
  const Wide power = PowerOfTen(a.scale);
  const Wide whole = a.digits / power;
  const Wide other = static_cast<Wide>(b_whole);
  if (whole != other) return whole < other ? -1 : 1;
  return CompareFractions(a.digits % power, power, b - b_whole);
}

Decimal Truncate(const Decimal& value) {
  return Decimal{value.digits / PowerOfTen(value.scale), 0};
}

Decimal Floor(const Decimal& value) {
  Decimal whole = Truncate(value);
  if (Compare(whole, value) > 0) whole.digits -= 1;
  return whole;
}

Decimal Ceil(const Decimal& value) {
  Decimal whole = Truncate(value);
  if (Compare(whole, value) < 0) whole.digits += 1;
  return whole;
}

Decimal Round(const Decimal& value) {
  const std::optional<Decimal> moved = Add(value, Decimal{5, 1});
  return moved ? Floor(*moved) : value;
}

}  // namespace kg_base
