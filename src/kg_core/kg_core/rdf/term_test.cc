#include "kg_core/rdf/term.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <tuple>

#include "gtest/gtest.h"
#include "kg_core/rdf/namespaces.h"

namespace kg_core {
namespace {

Term Typed(const std::string& text, const std::string& type) {
  return Literal(text, kXsd + type);
}

TEST(Term, KeepsLexicalFormsApart) {
  EXPECT_NE(Typed("1.50", "decimal"), Typed("1.5", "decimal"));
  EXPECT_NE(Typed("1", "integer"), Typed("1", "int"));
  EXPECT_NE(Literal("x"), LanguageLiteral("x", "en"));
  EXPECT_NE(Iri("x"), Blank("x"));
  EXPECT_EQ(Literal("x"), Typed("x", "string"));
  EXPECT_EQ(LanguageLiteral("x", "EN-gb"), LanguageLiteral("x", "en-GB"));
}

TEST(Term, OrdersTotally) {
  const Term terms[] = {Iri("a"),
                        Iri("b"),
                        Blank("a"),
                        Literal("a"),
                        LanguageLiteral("a", "en"),
                        Typed("a", "int")};
  for (const Term& a : terms) {
    for (const Term& b : terms) {
      EXPECT_EQ((a < b) + (b < a) + (a == b), 1) << a << " " << b;
    }
  }
}

TEST(Term, DoublesReadBackTheSame) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 20000; ++i) {
    const std::uint64_t bits = random();
    double value;
    std::memcpy(&value, &bits, sizeof(value));
    if (!std::isfinite(value)) continue;
    const auto back = NumericValue(DoubleLiteral(value));
    ASSERT_TRUE(back);
    ASSERT_EQ(*back, value) << DoubleLiteral(value);
  }
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(NumericValue(DoubleLiteral(inf)), inf);
  EXPECT_EQ(NumericValue(DoubleLiteral(-inf)), -inf);
  EXPECT_TRUE(std::isnan(*NumericValue(DoubleLiteral(std::nan("")))));
  EXPECT_EQ(DoubleLiteral(0.4).text, "0.4");
}

TEST(Term, KnowsTheValueOfEveryNumericType) {
  const struct {
    const char* text;
    const char* type;
    double value;
  } kCases[] = {
      {"3", "integer", 3},
      {"-3", "integer", -3},
      {"+3", "integer", 3},
      {"0.40", "decimal", 0.4},
      {"5.", "decimal", 5},
      {".5", "decimal", 0.5},
      {"-1.5E2", "double", -150},
      {"1e400", "double", INFINITY},
      {"1e-400", "double", 0},
      {"127", "byte", 127},
      {"0", "unsignedLong", 0},
      {"12", "positiveInteger", 12},
      {"2.5", "float", 2.5},
      {"7", "double", 7},
      {"-9223372036854775808", "long", -0x1p63},
  };
  for (const auto& c : kCases) {
    const auto value = NumericValue(Typed(c.text, c.type));
    ASSERT_TRUE(value) << c.text << " " << c.type;
    EXPECT_EQ(*value, c.value) << c.text << " " << c.type;
  }
}

TEST(Term, RefusesValuesOutsideTheirType) {
  const struct {
    const char* text;
    const char* type;
  } kCases[] = {
      {"128", "byte"},          {"-1", "nonNegativeInteger"},
      {"0", "negativeInteger"}, {"3.0", "integer"},
      {"1e2", "decimal"},       {"", "double"},
      {"1 ", "integer"},        {"0x10", "double"},
      {"inf", "double"},        {"nan", "double"},
      {"1e", "double"},         {"+", "integer"},
      {".", "decimal"},         {"INF", "decimal"},
      {"3", "string"},          {"3", "dateTime"},
  };
  for (const auto& c : kCases) {
    EXPECT_FALSE(NumericValue(Typed(c.text, c.type))) << c.text << c.type;
  }
  EXPECT_FALSE(NumericValue(Iri("3")));
  EXPECT_FALSE(NumericValue(Literal("3", "http://other#integer")));
}

TEST(Term, WritesTurtleAsPeopleDo) {
  EXPECT_EQ(ToTurtle(Iri(std::string(kEx) + "alpha")), "ex:alpha");
  EXPECT_EQ(ToTurtle(Iri(kFactsGraph)), "graph:facts");
  EXPECT_EQ(ToTurtle(Iri("http://a/b c")), "<http://a/b\\u0020c>");
  EXPECT_EQ(ToTurtle(Blank("b0")), "_:b0");
  EXPECT_EQ(ToTurtle(Literal("0.4")), "\"0.4\"");
  EXPECT_EQ(ToTurtle(IntegerLiteral(-3)), "-3");
  EXPECT_EQ(ToTurtle(BooleanLiteral(true)), "true");
  EXPECT_EQ(ToTurtle(Typed("1", "boolean")), "\"1\"^^xsd:boolean");
  EXPECT_EQ(ToTurtle(Typed("1.50", "decimal")), "1.50");
  EXPECT_EQ(ToTurtle(Typed("5.", "decimal")), "\"5.\"^^xsd:decimal");
  EXPECT_EQ(ToTurtle(Typed("1e3", "double")), "1e3");
  EXPECT_EQ(ToTurtle(Typed("0.4", "double")), "\"0.4\"^^xsd:double");
  EXPECT_EQ(ToTurtle(LanguageLiteral("sea", "en")), "\"sea\"@en");
  EXPECT_EQ(ToTurtle(Literal("a\"b\\\n\x01")), "\"a\\\"b\\\\\\n\\u0001\"");
}

TEST(Term, WritesNTriples) {
  EXPECT_EQ(ToNTriples(Iri("http://a")), "<http://a>");
  EXPECT_EQ(ToNTriples(IntegerLiteral(1)),
            "\"1\"^^<http://www.w3.org/2001/XMLSchema#integer>");
  EXPECT_EQ(ToNTriples(Literal("x")), "\"x\"");
  EXPECT_EQ(ToNTriples(LanguageLiteral("x", "en")), "\"x\"@en");
}

TEST(Term, RangesOfIntegersAreExact) {
  const auto is_number = [](const char* text, const char* type) {
    return NumericValue(Literal(text, kXsd + std::string(type))).has_value();
  };
  const std::tuple<const char*, const char*, const char*> kBounds[] = {
      {"long", "9223372036854775807", "9223372036854775808"},
      {"long", "-9223372036854775808", "-9223372036854775809"},
      {"unsignedLong", "18446744073709551615", "18446744073709551616"},
      {"int", "2147483647", "2147483648"},
      {"short", "-32768", "-32769"},
      {"byte", "+127", "+128"},
      {"unsignedByte", "0000255", "0000256"},
      {"nonNegativeInteger", "-0", "-1"},
      {"positiveInteger", "1", "0"},
      {"negativeInteger", "-1", "-00"},
      {"nonPositiveInteger", "0", "1"},
  };
  for (const auto& [type, inside, outside] : kBounds) {
    EXPECT_TRUE(is_number(inside, type)) << type << " " << inside;
    EXPECT_FALSE(is_number(outside, type)) << type << " " << outside;
  }
  EXPECT_TRUE(is_number("-1234567890123456789012345678901234567890",
                        "negativeInteger"));
}

TEST(GraphNames, TellIrisFromBlankNodes) {
  for (const Term& graph : {Iri("http://h/g"), Blank("b1"), Iri("urn:_:b1")}) {
    EXPECT_EQ(GraphFromName(ToGraphName(graph)), graph);
  }
  EXPECT_EQ(ToGraphName(Blank("b1")), "_:b1");
}

}  // namespace
}  // namespace kg_core
