#include "kg_base/text/decimal.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

namespace kg_base {
namespace {

Decimal Of(const std::string& text) { return *ParseDecimal(text); }

std::string Text(const std::optional<Decimal>& value) {
  return value ? ToString(*value) : "none";
}

// Compared with integer arithmetic in hundredths.
TEST(Decimal, CalculatesAsIntegersDo) {
  std::mt19937_64 random(7);
  std::uniform_int_distribution<long long> hundredths(-1000000, 1000000);
  for (int i = 0; i < 20000; ++i) {
    const long long a = hundredths(random);
    const long long b = hundredths(random);
    const Decimal x{a, 2};
    const Decimal y{b, 2};
    EXPECT_EQ(Compare(*Add(x, y), Decimal{a + b, 2}), 0);
    EXPECT_EQ(Compare(*Subtract(x, y), Decimal{a - b, 2}), 0);
    EXPECT_EQ(Compare(*Multiply(x, y), Decimal{a * b, 4}), 0);
    EXPECT_EQ(Compare(x, y), a < b ? -1 : a > b ? 1 : 0);
    EXPECT_EQ(Compare(Of(ToString(x)), x), 0);
    if (b == 0) continue;
    EXPECT_NEAR(ToDouble(*Divide(x, y)),
                static_cast<double>(a) / static_cast<double>(b),
                1e-12 * std::fabs(static_cast<double>(a)));
  }
}

TEST(Decimal, RoundsToWholeNumbers) {
  EXPECT_EQ(Text(Floor(Of("-1.1"))), "-2");
  EXPECT_EQ(Text(Ceil(Of("-1.9"))), "-1");
  EXPECT_EQ(Text(Round(Of("2.5"))), "3");
  EXPECT_EQ(Text(Round(Of("-2.5"))), "-2");
  EXPECT_EQ(Text(Truncate(Of("-2.9"))), "-2");
}

TEST(Decimal, HasNoAnswerForWhatDoesNotFit) {
  const Decimal big = Of("99999999999999999999999999999999999999");
  EXPECT_EQ(Text(Multiply(big, big)), "none");
  EXPECT_EQ(Text(Add(big, big)), "none");
  EXPECT_EQ(Text(Divide(big, Of("0"))), "none");
  EXPECT_EQ(Text(FromDouble(1e300)), "none");
  EXPECT_EQ(Text(FromDouble(std::nan(""))), "none");
  for (const char* text : {"", "-", ".", "1e3", "1.2.3", " 1", "0x1"}) {
    EXPECT_EQ(Text(ParseDecimal(text)), "none") << text;
  }
}

TEST(Decimal, WritesTheShortestForm) {
  EXPECT_EQ(Text(Of("+001.500")), "1.5");
  EXPECT_EQ(Text(Of("-.05")), "-0.05");
  EXPECT_EQ(Text(Of("-0")), "0");
  EXPECT_EQ(Text(Divide(Of("1"), Of("3"))), "0.333333333333333333");
  EXPECT_EQ(Text(FromDouble(0.1)), "0.1");
  EXPECT_EQ(Text(FromDouble(1e-7)), "0.0000001");
}

TEST(Decimal, ComparesWithTheExactValueOfADouble) {
  const auto compare = [](const char* a, double b) {
    return CompareWithDouble(Of(a), b);
  };
  EXPECT_EQ(compare("0.5", 0.5), 0);
  EXPECT_EQ(compare("-0.5", -0.5), 0);
  EXPECT_EQ(compare("0", -0.0), 0);
  EXPECT_EQ(compare("0.1", 0.1), -1);  // 0.1000000000000000055...
  EXPECT_EQ(compare("-0.1", -0.1), 1);
  EXPECT_EQ(compare("0.3", 0.3), 1);  // 0.2999999999999999888...
  EXPECT_EQ(compare("9007199254740993", 9007199254740992.0), 1);
  EXPECT_EQ(compare("9007199254740991.5", 9007199254740992.0), -1);
  EXPECT_EQ(compare("-9007199254740993", -9007199254740992.0), -1);
  EXPECT_EQ(compare("0", 5e-324), -1);
  EXPECT_EQ(compare("0", -5e-324), 1);
  // The double is 99999999999999997748809823456034029568.
  EXPECT_EQ(compare("99999999999999999999999999999999999999", 1e38), 1);
  EXPECT_EQ(compare("99999999999999997748809823456034029568", 1e38), 0);
  EXPECT_EQ(compare("99999999999999999999999999999999999999", 1e39), -1);
  EXPECT_EQ(compare("-99999999999999999999999999999999999999", -1e39), 1);
  EXPECT_EQ(compare("5", HUGE_VAL), -1);
  EXPECT_EQ(compare("5", -HUGE_VAL), 1);
}

TEST(Decimal, ComparesWithDoublesAsWithTheirFractions) {
  std::mt19937_64 random(11);
  std::uniform_int_distribution<long long> parts(-4000, 4000);
  for (int i = 0; i < 20000; ++i) {
    const long long a = parts(random);
    const long long b = parts(random);
    // a / 1000 against b / 1024, both exact.
    const long long left = a * 1024;
    const long long right = b * 1000;
    EXPECT_EQ(CompareWithDouble(Decimal{a, 3}, static_cast<double>(b) / 1024),
              left < right   ? -1
              : left > right ? 1
                             : 0)
        << a << " " << b;
  }
}

}  // namespace
}  // namespace kg_base
