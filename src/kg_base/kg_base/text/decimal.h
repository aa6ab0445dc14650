// Exact xsd:decimal and xsd:integer arithmetic: value = digits * 10^-scale.
//
// 128-bit digits hold about 38 significant digits; overflow gives nullopt,
// which an expression reports as an error rather than rounding.
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

// Reads [+-]digits[.digits]; nullopt if it is not a decimal or does not fit.
std::optional<Decimal> ParseDecimal(std::string_view text);
// Shortest form: "2", "-0.5".
std::string ToString(const Decimal& value);
double ToDouble(const Decimal& value);
// The nearest decimal of a double with at most 17 significant digits; nullopt
// for NaN, infinities and values that do not fit.
std::optional<Decimal> FromDouble(double value);

std::optional<Decimal> Add(const Decimal& a, const Decimal& b);
std::optional<Decimal> Subtract(const Decimal& a, const Decimal& b);
std::optional<Decimal> Multiply(const Decimal& a, const Decimal& b);
// Quotient with 18 digits after the point; nullopt for division by zero.
std::optional<Decimal> Divide(const Decimal& a, const Decimal& b);
int Compare(const Decimal& a, const Decimal& b);  // -1, 0, 1.
// The same with the exact value of a double, which must not be NaN.
int CompareWithDouble(const Decimal& a, double b);

// Rounding to integers: down, up, nearest (halves up), and towards zero.
Decimal Floor(const Decimal& value);
Decimal Ceil(const Decimal& value);
Decimal Round(const Decimal& value);
Decimal Truncate(const Decimal& value);

}  // namespace kg_base

#endif  // KG_BASE_TEXT_DECIMAL_H_
