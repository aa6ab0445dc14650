#include "kg_core/sparql/values.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <random>
#include <string>
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

}  // namespace
}  // namespace kg_core::sparql
