#include "kg_core/rdf/turtle.h"

#include <map>
#include <random>
#include <set>

#include "gtest/gtest.h"
#include "kg_base/common/input_error.h"
#include "kg_base/common/text.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_core/rdf/store.h"

namespace kg_core {
namespace {

using kg_base::InputError;

const Term kFacts = Iri(kFactsGraph);

Term Ex(const std::string& name) { return Iri(kEx + name); }

std::vector<Statement> Read(std::string_view text) {
  return ParseTurtle(text, "facts.ttl", kFacts);
}

std::string GetError(std::string_view text, const TurtleLimits& limits = {}) {
  try {
    ParseTurtle(text, "facts.ttl", kFacts, limits);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

// N-Triples lines with blank nodes numbered in order of first occurrence.
std::multiset<std::string> Lines(const std::vector<Statement>& statements) {
  std::map<Term, std::string> blanks;
  const auto shown = [&](const Term& term) {
    if (!term.is_blank()) return ToNTriples(term);
    return blanks.try_emplace(term, "_:" + std::to_string(blanks.size()))
        .first->second;
  };
  std::multiset<std::string> lines;
  for (const Statement& s : statements) {
    std::string line = shown(s.subject) + " ";
    line += shown(s.predicate) + " ";
    lines.insert(line + shown(s.object));
  }
  return lines;
}

TEST(Turtle, KnowsOurPrefixesUndeclared) {
  const auto statements = Read("ex:a a owl:Class ; ex:p 1.50, 'x'@EN, true .");
  ASSERT_EQ(statements.size(), 4u);
  EXPECT_EQ(statements[0].subject, Ex("a"));
  EXPECT_EQ(statements[0].predicate, Iri(kRdf + std::string("type")));
  EXPECT_EQ(statements[1].object,
            Literal("1.50", kXsd + std::string("decimal")));
  EXPECT_EQ(statements[2].object, LanguageLiteral("x", "en"));
  EXPECT_EQ(statements[3].object, BooleanLiteral(true));
  EXPECT_EQ(statements[3].graph, kFacts);
}

TEST(Turtle, TakesDeclaredPrefixesAndBases) {
  const auto statements = Read(
      "@prefix f: <http://f/> . @base <http://base/x/> . BASE <y/>\n"
      "PREFIX ex: <http://other/>\n"
      "f:a ex:b <c> ; f:d\\~ <http://h/../k> .");
  ASSERT_EQ(statements.size(), 2u);
  EXPECT_EQ(statements[0].subject, Iri("http://f/a"));
  EXPECT_EQ(statements[0].predicate, Iri("http://other/b"));
  EXPECT_EQ(statements[0].object, Iri("http://base/x/y/c"));
  EXPECT_EQ(statements[1].predicate, Iri("http://f/d~"));
  EXPECT_EQ(statements[1].object, Iri("http://h/../k"));  // Kept as written.
}

TEST(Turtle, AnIntegerBeforeThePointIsAnInteger) {
  const std::pair<const char*, const char*> kCases[] = {
      {"ex:a ex:p 2.", "2"},
      {"ex:a ex:p +2.", "+2"},
      {"ex:a ex:p -12.\n", "-12"},
      {"ex:a ex:p 2.# note", "2"},
      {"ex:a ex:p 2.ex:b ex:p 2.", "2"},
      {"ex:a ex:p 2.<http://h/e1> ex:p 2.", "2"},
      {"ex:a ex:p 2.[] ex:p 2.", "2"},
      {"ex:a ex:p 2, 2 . _:e ex:p 2.", "2"},
      {"[ ex:p 2 ] ex:p 2.", "2"},
      {"ex:a ex:p 2.@prefix f: <http://f/> .", "2"},
  };
  for (const auto& [text, number] : kCases) {
    const auto statements = Read(text);
    EXPECT_FALSE(statements.empty()) << text;
    for (const Statement& s : statements) {
      if (s.object.is_blank()) continue;
      EXPECT_EQ(s.object, Literal(number, kXsd + std::string("integer")))
          << text;
    }
  }
}

TEST(Turtle, PointsInsideOfNumbersBelongToThem) {
  const std::pair<const char*, const char*> kCases[] = {
      {"2.5", "decimal"}, {".5", "decimal"},    {"-.5", "decimal"},
      {"2.e3", "double"}, {"2.5E-3", "double"}, {"2e+3", "double"},
  };
  for (const auto& [number, type] : kCases) {
    for (const char* end : {".", " .", ".\nex:b ex:q 'x'."}) {
      const auto statements = Read(std::string("ex:a ex:p ") + number + end);
      ASSERT_FALSE(statements.empty()) << number;
      EXPECT_EQ(statements[0].object, Literal(number, kXsd + std::string(type)))
          << number << end;
    }
  }
}

// Examples of https://www.rfc-editor.org/rfc/rfc3986#section-5.4
TEST(Turtle, RemovesDotSegmentsOfRelativeIris) {
  const std::pair<const char*, const char*> kCases[] = {
      {"g", "http://a/b/c/g"},
      {"./g", "http://a/b/c/g"},
      {"..", "http://a/b/"},
      {"../../g", "http://a/g"},
      {"../../../g", "http://a/g"},
      {"./../g", "http://a/b/g"},
      {"g/./h", "http://a/b/c/g/h"},
      {"g/../h", "http://a/b/c/h"},
      {"/./g", "http://a/g"},
      {"g;x=1/../y", "http://a/b/c/y"},
      {"g?y/../x", "http://a/b/c/g?y/../x"},
      {"", "http://a/b/c/d;p?q"},
      {"//g", "http://g"},
      {"?y", "http://a/b/c/d;p?y"},
  };
  for (const auto& [reference, iri] : kCases) {
    const std::string base = "@base <http://a/b/c/d;p?q> . ";
    const auto plain = Read(base + "ex:a ex:p <" + reference + "> .");
    ASSERT_EQ(plain.size(), 1u);
    EXPECT_EQ(plain[0].object, Iri(iri)) << reference;
    const auto prefixed =
        Read(base + "@prefix f: <" + reference + "> . ex:a ex:p f: .");
    EXPECT_EQ(prefixed.at(0).object, Iri(iri)) << reference;
  }
  EXPECT_EQ(Read("@base <http://a/b/c> . @base <../x/./y/> . <z> ex:p 1.")
                .at(0)
                .subject,
            Iri("http://a/x/y/z"));
}

TEST(Turtle, MessagesKeepCharactersWhole) {
  for (const char* text : {"ex:a ex:p \xE2\x80\x9C"
                           "a\xE2\x80\x9D .",
                           "ex:a \xC2\xA0 ex:p 1 .",
                           "ex:a ex:p 1 \xE2\x80\x93 .", "\xF0\x9F\x98\x80"}) {
    EXPECT_FALSE(kg_base::FirstBadUtf8(GetError(text))) << GetError(text);
    EXPECT_NE(GetError(text), "no error") << text;
  }
}

TEST(Turtle, ReadsNoStatementsFromEmptyText) {
  EXPECT_TRUE(Read("").empty());
  EXPECT_TRUE(Read("  \n# only a note").empty());
  EXPECT_TRUE(Read("@prefix f: <http://f/> .").empty());
}

TEST(Turtle, BlankNodesNeverMeetAcrossTexts) {
  const char* text = "_:x ex:p [ ex:q _:x ] , ( 1 2 ) .";
  std::set<Term> blanks;
  std::size_t per_text = 0;
  for (int i = 0; i < 50; ++i) {
    for (const Statement& s : Read(text)) blanks.insert(s.subject);
    if (i == 0) per_text = blanks.size();
  }
  EXPECT_EQ(per_text, 4u);  // _:x, the [], two list cells.
  EXPECT_EQ(blanks.size(), 50 * per_text);
}

TEST(Turtle, ShortAndLongWritingsMeanTheSame) {
  EXPECT_EQ(Lines(Read("ex:a ex:p [ ex:q 1 ; ex:r 'x' ] , ( 2 ) .")),
            Lines(Read("ex:a ex:p _:x . _:x ex:q \"1\"^^xsd:integer .\n"
                       "_:x ex:r \"x\" . ex:a ex:p _:y . _:y rdf:first 2 ;\n"
                       "rdf:rest rdf:nil .")));
}

TEST(Turtle, BlankLabelsOfOneTextStayApart) {
  const auto statements =
      Read("_:b1 ex:p [] . _:b2 ex:p [] . _:genid1 ex:p [] . _:b1 ex:q 1 .");
  std::set<Term> blanks;
  for (const Statement& s : statements) {
    blanks.insert(s.subject);
    if (s.object.is_blank()) blanks.insert(s.object);
  }
  EXPECT_EQ(blanks.size(), 6u);
  EXPECT_EQ(statements[0].subject, statements[3].subject);
}

// serd names nodes without a label b1, b2, ..., and reads _:b1 as B1.
TEST(Turtle, KeepsBlankLabelsApartThatSerdWouldMerge) {
  const auto statements = Read(
      "_:B1 ex:p [] .\n_:b1 ex:p [].\n_:b2 ex:p (1), ex:a._:b3, \"x\"._:b3 "
      "ex:q '._:b4 ' .");
  std::set<Term> blanks;
  for (const Statement& s : statements) {
    if (s.subject.is_blank()) blanks.insert(s.subject);
    if (s.object.is_blank()) blanks.insert(s.object);
  }
  EXPECT_EQ(statements.size(), 8u);
  EXPECT_EQ(blanks.size(), 7u);  // Four labels, two [], a list cell.
}

TEST(Turtle, NamesThePlaceOfAnError) {
  EXPECT_EQ(GetError("ex:a ex:p 1 .\n  foaf:b ex:p 2 ."),
            "facts.ttl:2:3: unknown prefix 'foaf:'; expected one declared "
            "with @prefix, or one of ours");
  EXPECT_EQ(GetError("ex:a ex:p\n <b> .").rfind("facts.ttl:2:", 0), 0u);
  EXPECT_EQ(GetError("ex:a ex:p 1 .\nex:a 3 4 .").rfind("facts.ttl:2:", 0), 0u)
      << GetError("ex:a ex:p 1 .\nex:a 3 4 .");
}

TEST(Turtle, RefusesWhatIsNotTurtle) {
  const char* kBad[] = {
      "ex:a ex:p 1",
      "ex:a ex:p .",
      "ex:a ex:p \"open .",
      "ex:a ex:p 'a\nb' .",
      "ex:a ex:p 1 . )",
      "ex:a ex:p 1 . }",
      "ex:a ex:p [ ex:q 1 .",
      "ex:a ex:p ( 1 2 .",
      "ex:a ex:p <http://a b> .",
      "ex:a ex:p <http://a\\u0020b> .",
      "ex:a ex:p <open .",
      "\"x\" ex:p 1 .",
      "ex:a \"p\" 1 .",
      "ex:a _:p 1 .",
      "{ ex:a ex:p 1 }",
      "ex:g { ex:a ex:p 1 }",
      "ex:g {}",
      "ex:a ex:p \"\\q\" .",
      "ex:a ex:p 1 .. ",
      "@prefix f <http://f/> .",
      "@prefix f: <relative/> . f:a f:b f:c .",
      "garbage",
      "ex:a ex:p \"1\"^^foo:bar .",
      "ex:a ex:p \"1\"^^<bar> .",
  };
  for (const char* text : kBad) EXPECT_THROW(Read(text), InputError) << text;
}

TEST(Turtle, RefusesBytesThatAreNoText) {
  EXPECT_EQ(GetError("ex:a ex:p \"\n\xC3(\" ."),
            "facts.ttl:2:1: byte that is not UTF-8");
  EXPECT_EQ(GetError(std::string_view("ex:a\0 ex:p 1 .", 14)),
            "facts.ttl:1:5: NUL byte; expected text");
  for (const char* bad : {"\xC0\x80", "\xED\xA0\x80", "\xF4\x90\x80\x80",
                          "\xFF", "\xE2\x82", "\x80"}) {
    EXPECT_THROW(Read(std::string("ex:a ex:p \"") + bad + "\" ."), InputError);
  }
}

TEST(Turtle, RefusesDepthAndSizeBeforeReading) {
  for (const auto& [open, close] : {std::pair("[ ex:p ", "]"), {"( ", ")"}}) {
    const auto nested = [&, o = open, c = close](int depth) {
      std::string text = "ex:a ex:p ";
      for (int i = 0; i < depth; ++i) text += o;
      text += "1 ";
      for (int i = 0; i < depth; ++i) text += c;
      return text + " .";
    };
    EXPECT_NO_THROW(Read(nested(200)));
    EXPECT_THROW(Read(nested(201)), InputError);
    EXPECT_THROW(Read(nested(50000)), InputError);
  }
  EXPECT_EQ(GetError("ex:a ex:p 1 .", {5, 200}),
            "facts.ttl:1:1: text of 13 bytes; expected at most 5");
}

TEST(Turtle, CountsNoBracketsInsideTextAndNames) {
  const std::string many(1000, '(');
  EXPECT_EQ(Read("ex:a ex:p \"" + many + "\", '''" + many + "''' # " + many +
                 "\n, <http://x/" + many + "> .")
                .size(),
            3u);
  std::string escaped = "ex:a ex:p ex:b";
  for (int i = 0; i < 1000; ++i) escaped += "\\(";
  EXPECT_EQ(Read(escaped + " .").size(), 1u);
}

TEST(Turtle, MutatedTextIsReadOrRefusedNeverWorse) {
  const std::string good =
      "@prefix f: <http://f/> .\n_:x a f:C ; ex:p [ ex:q ( 1 'a'@en ) ], "
      "\"\"\"long\"\"\"^^xsd:string, 4e1, <http://h/k#l> . # end\n";
  std::mt19937 random(11);
  for (int i = 0; i < 20000; ++i) {
    std::string text = good;
    for (int changes = 1 + random() % 3; changes > 0; --changes) {
      text[random() % text.size()] = static_cast<char>(random());
    }
    try {
      Read(text.substr(0, random() % (text.size() + 1)));
    } catch (const InputError& error) {
      ASSERT_EQ(std::string(error.what()).rfind("facts.ttl:", 0), 0u);
    }
  }
}

TEST(Turtle, AMissingFileIsNamed) {
  try {
    ParseTurtleFile("/nowhere/facts.ttl", kFacts);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).rfind("/nowhere/facts.ttl", 0), 0u);
  }
}

}  // namespace
}  // namespace kg_core
