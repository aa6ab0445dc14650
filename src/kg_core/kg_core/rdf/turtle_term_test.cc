#include <random>

#include "gtest/gtest.h"
#include "kg_base/common/input_error.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_core/rdf/turtle.h"

namespace kg_core {
namespace {

using kg_base::InputError;

Term Typed(const std::string& text, const std::string& type) {
  return Literal(text, kXsd + type);
}

TEST(TurtleTerm, ReadsEveryFormOfTheHeader) {
  EXPECT_EQ(ParseTurtleTerm("ex:alpha"), Iri(std::string(kEx) + "alpha"));
  EXPECT_EQ(ParseTurtleTerm("<http://a/b>"), Iri("http://a/b"));
  EXPECT_EQ(ParseTurtleTerm("\"x\"@EN"), LanguageLiteral("x", "en"));
  EXPECT_EQ(ParseTurtleTerm("0.4"), Typed("0.4", "decimal"));
  EXPECT_EQ(ParseTurtleTerm(" 3\n"), IntegerLiteral(3));
  EXPECT_EQ(ParseTurtleTerm("true"), BooleanLiteral(true));
  EXPECT_EQ(ParseTurtleTerm("1e3"), Typed("1e3", "double"));
  EXPECT_EQ(ParseTurtleTerm("_:b0"), Blank("b0"));
  EXPECT_EQ(ParseTurtleTerm("'''a'b''c\n'''"), Literal("a'b''c\n"));
  EXPECT_EQ(ParseTurtleTerm("\"POINT(1 2)\"^^geo:wktLiteral"),
            Literal("POINT(1 2)", std::string(kGeo) + "wktLiteral"));
  EXPECT_EQ(ParseTurtleTerm("ex:a\\~b.c:d%20"),
            Iri(std::string(kEx) + "a~b.c:d%20"));
  EXPECT_EQ(ParseTurtleTerm("ex:run\\."), Iri(std::string(kEx) + "run."));
  EXPECT_EQ(ParseTurtleTerm("\"\\u00e9\\U0001F30A\""),
            Literal("\xC3\xA9\xF0\x9F\x8C\x8A"));
}

TEST(TurtleTerm, RefusesAnythingThatIsNotExactlyOneTerm) {
  const char* kBad[] = {
      "",
      " ",
      "ex:a . ex:b ex:c ex:d",
      "ex:a .",
      "ex:a, ex:b",
      "ex:a; ex:p ex:q",
      "ex:a ex:b",
      "ex:a # note",
      "ex:a\n@prefix ex: <http://evil/> .",
      "\"x\" . ex:b ex:c \"y\"",
      "\"x\"\"y\"",
      "3 4",
      "3 .",
      "3.",
      "+",
      "1e",
      "truex",
      "alpha",
      "a",
      "foaf:name",
      "[]",
      "[ ex:p 1 ]",
      "( 1 2 )",
      "()",
      "?x",
      "<relative>",
      "<http://a b>",
      "<http://a\\u0020b>",
      "<http://a",
      "<http://a> <http://b>",
      "\"open",
      "\"a\nb\"",
      "\"a\"@",
      "\"a\"@en-",
      "\"a\"^^",
      "\"a\"^^foo:bar",
      "\"a\"^^<b>",
      "\"\\q\"",
      "\"\\uD800\"",
      "\"\\U00110000\"",
      "\"\\u12\"",
      "ex:a%2",
      "ex:a\\x",
      "ex:a.",
      "_:",
      "_:-a",
      "_:a b",
      "\"\xC0\x80\"",
      "@prefix",
      "{}",
  };
  for (const char* text : kBad) {
    EXPECT_THROW(ParseTurtleTerm(text), InputError) << text;
  }
}

TEST(TurtleTerm, ErrorsQuoteTheTextAndTheExpectation) {
  try {
    ParseTurtleTerm("ex:a .\nex:b ex:c ex:d");
    FAIL();
  } catch (const InputError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("'ex:a . ex:b ex:c ex:d'"), std::string::npos) << text;
    EXPECT_NE(text.find("expected an IRI"), std::string::npos) << text;
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
  }
  try {
    ParseTurtleTerm("foaf:name");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("prefix 'foaf:' is unknown"),
              std::string::npos);
  }
}

Term RandomTerm(std::mt19937* random) {
  const auto pick = [&](int n) { return static_cast<int>((*random)() % n); };
  const char* kPieces[] = {"a", "Z", "0", "-", ".",        "\"", "\\", "\n",
                           "'", "@", "^", " ", "\xC3\xA9", "#",  "\t", "\x01"};
  std::string text;
  for (int i = pick(8); i > 0; --i) text += kPieces[pick(16)];
  switch (pick(5)) {
    case 0:
      return Iri(kEx + std::string("a") + std::to_string(pick(1000)));
    case 1:
      return LanguageLiteral(text, "en-gb");
    case 2:
      return Literal(text);
    case 3:
      return Literal(text, std::string(kGeo) + "wktLiteral");
    default:
      return DoubleLiteral(pick(100000) * 0.01);
  }
}

TEST(TurtleTerm, ReadsWhatToTurtleAndToNTriplesWrite) {
  std::mt19937 random(3);
  for (int i = 0; i < 5000; ++i) {
    const Term term = RandomTerm(&random);
    ASSERT_EQ(ParseTurtleTerm(ToTurtle(term)), term);
    ASSERT_EQ(ParseTurtleTerm(ToNTriples(term)), term);
  }
}

// serd serves as the independent parser.
TEST(TurtleTerm, AgreesWithTheTurtleReader) {
  std::mt19937 random(4);
  for (int i = 0; i < 2000; ++i) {
    const std::string text = ToTurtle(RandomTerm(&random));
    const auto statements =
        ParseTurtle("ex:s ex:p " + text + " .", "test", Iri(kFactsGraph));
    ASSERT_EQ(statements.size(), 1u);
    ASSERT_EQ(statements[0].object, ParseTurtleTerm(text)) << text;
  }
}

TEST(TurtleTerm, AcceptsNoMutationThatTheTurtleReaderRefuses) {
  std::mt19937 random(5);
  const std::string kSyntax = "\"'\\<>.,;:@^#[](){}_ \nae0-%";
  int accepted = 0;
  for (int i = 0; i < 20000; ++i) {
    std::string text = ToTurtle(RandomTerm(&random));
    text[random() % text.size()] = kSyntax[random() % kSyntax.size()];
    try {
      const Term term = ParseTurtleTerm(text);
      if (term.is_blank()) continue;
      ++accepted;
      const auto statements =
          ParseTurtle("ex:s ex:p " + text + " .", "test", Iri(kFactsGraph));
      ASSERT_EQ(statements.size(), 1u) << text;
      ASSERT_EQ(statements[0].object, term) << text;
    } catch (const InputError&) {
      EXPECT_THROW(ParseTurtleTerm(text), InputError) << text;
    }
  }
  EXPECT_GT(accepted, 1000);
}

}  // namespace
}  // namespace kg_core
