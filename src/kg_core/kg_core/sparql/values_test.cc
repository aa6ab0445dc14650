#include "kg_core/sparql/values.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "kg_core/rdf/namespaces.h"

namespace kg_core::sparql {
namespace {

Term Typed(const std::string& text, const char* type) {
  return Literal(text, std::string(kXsd) + type);
}

std::vector<Term> ManyTerms() {
  return {Blank("b"),
          Blank("a"),
          Iri("http://b"),
          Iri("http://a"),
          IntegerLiteral(10),
          IntegerLiteral(9),
          Typed("09", "integer"),
          Typed("9.0", "decimal"),
          Typed("9.5", "decimal"),
          DoubleLiteral(9.25),
          Typed("9007199254740991", "integer"),
          Typed("9007199254740992", "long"),
          Typed("9007199254740993", "integer"),
          Typed("9007199254740993.5", "decimal"),
          DoubleLiteral(9007199254740992.0),
          DoubleLiteral(9007199254740994.0),
          Typed("0.1", "decimal"),
          Typed("0.1", "float"),
          DoubleLiteral(0.1),
          Typed("1e300", "double"),
          Typed("300", "unsignedByte"),
          Typed("NaN", "double"),
          Typed("NaN", "float"),
          Typed("-INF", "double"),
          Typed("x", "integer"),
          BooleanLiteral(true),
          Typed("0", "boolean"),
          Typed("2020-11-01T06:00:00Z", "dateTime"),
          Typed("2020-11-01T01:00:00-05:00", "dateTime"),
          Typed("2020-11-01T05:59:59Z", "dateTime"),
          Typed("2020-11-01", "date"),
          Typed("2019-11-01", "date"),
          Literal("b"),
          Literal("a"),
          Literal(""),
          LanguageLiteral("a", "en"),
          LanguageLiteral("a", "de"),
          Literal("a", "http://type"),
          Literal("a", "http://a-type")};
}

int GetSign(int value) { return (value > 0) - (value < 0); }

TEST(Values, RankTermsAsOrderOfDoes) {
  std::mt19937 random(3);
  const std::vector<Term> all = ManyTerms();
  for (int round = 0; round < 200; ++round) {
    std::vector<const Term*> terms;
    for (int i = 0; i < 12; ++i) terms.push_back(&all[random() % all.size()]);
    int steps = 0;
    const std::vector<int> ranks = ComputeRanks(terms, [&steps] { ++steps; });
    EXPECT_GE(steps, 12);
    for (std::size_t i = 0; i < terms.size(); ++i) {
      for (std::size_t j = 0; j < terms.size(); ++j) {
        EXPECT_EQ(GetSign(ranks[i] - ranks[j]),
                  GetSign(CompareTerms(terms[i], terms[j])))
            << *terms[i] << " " << *terms[j];
      }
    }
  }
  EXPECT_TRUE(ComputeRanks({}, [] {}).empty());
}

TEST(Values, OrderKindsAsOrderByAsks) {
  const Term blank = Blank("z");
  const Term iri = Iri("http://a");
  const Term literal = Literal("a");
  EXPECT_EQ(CompareTerms(nullptr, nullptr), 0);
  EXPECT_EQ(CompareTerms(nullptr, &blank), -1);
  EXPECT_EQ(CompareTerms(&blank, &iri), -1);
  EXPECT_EQ(CompareTerms(&literal, &iri), 1);
}

// Antisymmetric and transitive, equality included.
TEST(Values, CompareTermsIsAnOrder) {
  const std::vector<Term> all = ManyTerms();
  const auto compare = [&all](std::size_t i, std::size_t j) {
    return GetSign(CompareTerms(&all[i], &all[j]));
  };
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = 0; j < all.size(); ++j) {
      EXPECT_EQ(compare(i, j), -compare(j, i)) << all[i] << " " << all[j];
      for (std::size_t k = 0; k < all.size(); ++k) {
        if (compare(i, j) > 0 || compare(j, k) > 0) continue;
        const int least = std::min(compare(i, j), compare(j, k));
        EXPECT_EQ(compare(i, k), least)
            << all[i] << " " << all[j] << " " << all[k];
      }
    }
  }
}

// What '<' says is never contradicted.
TEST(Values, OrderRefinesTheOperator) {
  const std::vector<Term> all = ManyTerms();
  for (const Term& a : all) {
    for (const Term& b : all) {
      if (Compare(a, b) != Order::kLess) continue;
      EXPECT_LT(CompareTerms(&a, &b), 0) << a << " " << b;
    }
  }
}

TEST(Values, RoundsToTheNearestInteger) {
  const std::pair<double, double> kCases[] = {
      {0.49999999999999994, 0.0},
      {-0.49999999999999994, -0.0},
      {0.5, 1.0},
      {-0.5, -0.0},
      {-0.0, -0.0},
      {-1e-300, -0.0},
      {-1.5, -1.0},
      {-0.50000000000000011, -1.0},
      {2.4999999999999996, 2.0},
      {4503599627370495.5, 4503599627370496.0},
      {4503599627370497.0, 4503599627370497.0},
      {-4503599627370497.0, -4503599627370497.0},
      {9007199254740991.0, 9007199254740991.0},
      {1e300, 1e300},
      {HUGE_VAL, HUGE_VAL},
      {-HUGE_VAL, -HUGE_VAL},
  };
  for (const auto& [value, rounded] : kCases) {
    EXPECT_EQ(RoundHalfUp(value), rounded) << value;
    EXPECT_EQ(std::signbit(RoundHalfUp(value)), std::signbit(rounded)) << value;
  }
  EXPECT_TRUE(std::isnan(RoundHalfUp(std::nan(""))));
}

TEST(Values, IllTypedNumbersHaveNoValue) {
  const std::pair<const char*, const char*> kIllTyped[] = {
      {"300", "unsignedByte"},
      {"-1", "nonNegativeInteger"},
      {"0", "positiveInteger"},
      {"128", "byte"},
      {"9223372036854775808", "long"},
      {"1.0", "int"},
      {"x", "decimal"},
      {"1e3", "decimal"},
      {"", "integer"},
      {"1f", "float"},
  };
  for (const auto& [text, type] : kIllTyped) {
    const Term term = Typed(text, type);
    EXPECT_FALSE(ToNumber(term)) << term;
    EXPECT_FALSE(Compare(term, IntegerLiteral(1))) << term;
    EXPECT_FALSE(Equal(term, IntegerLiteral(1))) << term;
    EXPECT_EQ(EffectiveBoolean(term), false) << term;
  }
  EXPECT_TRUE(ToNumber(Typed("200", "unsignedByte")));
  EXPECT_TRUE(ToNumber(Typed("9223372036854775807", "long")));
}

// The W3C's open-eq-08 to open-eq-12.
TEST(Values, TextsWithALanguageEqualNothingElse) {
  const Term english = LanguageLiteral("xyz", "en");
  for (const Term& other :
       {Literal("xyz", "http://h/unknown"), Typed("xyz", "integer"),
        Literal("xyz"), LanguageLiteral("xyz", "fr")}) {
    EXPECT_EQ(Equal(english, other), false) << other;
    EXPECT_EQ(Equal(other, english), false) << other;
  }
  EXPECT_FALSE(Equal(Literal("xyz"), Literal("xyz", "http://h/unknown")));
}

}  // namespace
}  // namespace kg_core::sparql
