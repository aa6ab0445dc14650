// Exact xsd:decimal and xsd:integer arithmetic: value = digits * 10^-scale.
//
// 128-bit digits hold some 38 significant digits; what does not fit is "no
// answer", which an expression reports as an error rather than rounding.
// https://www.w3.org/TR/xpath-functions/#op.numeric

#ifndef KG_BASE_TEXT_DECIMAL_H_
#define KG_BASE_TEXT_DECIMAL_H_

#include <optional>
#include <string>
#include <string_view>

namespace kg_base {

struct Decimal {
  __int128 digits = 0;
  int scale = 0;  // Digits after the point; never negative.
};

// Reads [+-]digits[.digits]; nothing if it is no decimal or does not fit.
std::optional<Decimal> ParseDecimal(std::string_view text);
// Shortest form: "2", "-0.5".
std::string ToString(const Decimal& value);
double ToDouble(const Decimal& value);
// The nearest decimal of a double with at most 17 significant digits; nothing
// for NaN, infinities and what does not fit.
std::optional<Decimal> FromDouble(double value);

std::optional<Decimal> Add(const Decimal& a, const Decimal& b);
std::optional<Decimal> Subtract(const Decimal& a, const Decimal& b);
std::optional<Decimal> Multiply(const Decimal& a, const Decimal& b);
// To 18 digits after the point; nothing for division by zero.
std::optional<Decimal> Divide(const Decimal& a, const Decimal& b);
int Compare(const Decimal& a, const Decimal& b);  // -1, 0, 1.

// Whole numbers below, above, nearest (halves go up), and towards zero.
Decimal Floor(const Decimal& value);
Decimal Ceil(const Decimal& value);
Decimal Round(const Decimal& value);
Decimal Truncate(const Decimal& value);

}  // namespace kg_base

#endif  // KG_BASE_TEXT_DECIMAL_H_
