#include "kg_core/rdf/syntax.h"

#include <fstream>
#include <random>
#include <set>

#include "gtest/gtest.h"
#include "kg_base/common/input_error.h"
#include "kg_base/common/temporary_folder.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_core/sparql/isomorphism.h"
#include "kg_core/sparql/testing/vector_view.h"

namespace kg_core {
namespace {

using kg_base::InputError;

constexpr char kDefault[] = "http://example.org/mission/graph/default";

Term Ex(const std::string& name) { return Iri(kEx + name); }

using Statements = std::vector<Statement>;

Statements Read(std::string_view text, RdfSyntax syntax,
                const TurtleLimits& limits = {}) {
  return ParseRdf(text, syntax, {"facts", Iri(kDefault)}, limits);
}

std::string GetError(std::string_view text, RdfSyntax syntax) {
  try {
    Read(text, syntax);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

void Fill(const Statements& statements, VectorView* view) {
  for (const Statement& s : statements) {
    view->Add(s.subject, s.predicate, s.object, s.graph);
  }
}

template <typename List>
const auto& PickOne(const List& list, std::mt19937& random) {
  return list[random() % list.size()];
}

// Literals made of character sequences that have caused errors in writers or
// readers.
Term RandomLiteral(std::mt19937& random) {
  static const std::vector<std::string> kPieces = {
      "",       "a",           "\"",         "\\",      "\n",     "\r",
      "\t",     "\b",          "\f",         "\x7F",    "\x01",   "'",
      "\"\"\"", "}",           "{ (",        "<",       ">",      "# ",
      " .",     "_:b1",        "@en",        "^^",      "\\u",    "\u00e9",
      "\u2028", "\ufeff",      "\U0001F30A", "e\u0301", "\ufffd", "1.50",
      "$",      "\xEF\xBF\xBE"};
  static const std::vector<std::string> kTypes = {
      "string", "integer", "decimal", "double", "boolean", "dateTime"};
  static const std::vector<std::string> kBare = {"1",    "-0",    "+7",  "1.5",
                                                 ".5",   "5.",    "1e3", "1.E3",
                                                 "true", "false", "NaN"};
  std::string text;
  for (int i = random() % 5; i > 0; --i) text += PickOne(kPieces, random);
  switch (random() % 4) {
    case 0:
      return LanguageLiteral(text, random() % 2 == 0 ? "en" : "zh-hant-tw");
    case 1:
      return Literal(text, kXsd + PickOne(kTypes, random));
    case 2:
      return Literal(PickOne(kBare, random), kXsd + PickOne(kTypes, random));
    default:
      return Literal(text);
  }
}

Term RandomIri(std::mt19937& random) {
  static const std::vector<std::string> kIris = {kEx + std::string("a"),
                                                 kEx + std::string("a.b"),
                                                 kEx + std::string("-a"),
                                                 kEx + std::string(),
                                                 kEx + std::string("a/b#c"),
                                                 kEx + std::string("100%25"),
                                                 "http://h/\u00e9\U0001F30A",
                                                 "urn:x:(1,2;'3')",
                                                 "http://h/?q=1&r=[2]#f",
                                                 "mailto:a@b.c",
                                                 kRdf + std::string("type"),
                                                 kXsd + std::string("string"),
                                                 "http://h/a_:b1",
                                                 "tag:x._:b1"};
  return Iri(PickOne(kIris, random));
}

Term RandomBlank(std::mt19937& random) {
  static const std::vector<std::string> kLabels = {
      "b1", "b2", "B1", "B2", "genid1", "u", "1", "a.b", "x-y", "\u00e9"};
  return Blank(PickOne(kLabels, random));
}

Term RandomNode(std::mt19937& random) {
  return random() % 2 == 0 ? RandomBlank(random) : RandomIri(random);
}

Statements RandomStatements(std::mt19937& random) {
  Statements statements;
  const std::vector<Term> graphs = {Iri(kDefault), Iri(kFactsGraph),
                                    Iri("http://h/g(1)"), Blank("a"),
                                    Blank("graph")};
  for (int i = random() % 12; i > 0; --i) {
    const bool is_literal = random() % 2 == 0;
    statements.push_back(
        {RandomNode(random), RandomIri(random),
         is_literal ? RandomLiteral(random) : RandomNode(random),
         PickOne(graphs, random)});
  }
  return statements;
}

Statements InGraph(Statements statements, const std::string& graph) {
  for (Statement& s : statements) s.graph = Iri(graph);
  return statements;
}

TEST(RdfSyntaxes, BringBackWhatTheyWrote) {
  std::mt19937 random(3);
  for (int i = 0; i < 3000; ++i) {
    const Statements statements = RandomStatements(random);
    VectorView view;
    Fill(statements, &view);
    for (const RdfSyntaxName& syntax : RdfSyntaxes()) {
      const std::string text =
          WriteRdf(view, {ListGraphs(view), kDefault}, syntax.syntax);
      const Statements want =
          syntax.has_graphs ? statements : InGraph(statements, kDefault);
      ASSERT_TRUE(IsIsomorphic(Read(text, syntax.syntax), want))
          << syntax.name << "\n"
          << text;
    }
  }
}

TEST(RdfSyntaxes, WriteOnlyTheChosenGraphs) {
  const Statements statements = {
      {Ex("a"), Ex("p"), Literal("1"), Iri("http://h/one")},
      {Ex("a"), Ex("p"), Literal("2"), Iri("http://h/two")}};
  VectorView view;
  Fill(statements, &view);
  EXPECT_EQ(ListGraphs(view),
            (std::vector<std::string>{"http://h/one", "http://h/two"}));
  EXPECT_EQ(
      WriteRdf(view, {{"http://h/two", "http://h/none"}}, RdfSyntax::kNQuads),
      "<http://example.org/mission/a> <http://example.org/mission/p> \"2\" "
      "<http://h/two> .\n");
  EXPECT_EQ(WriteRdf(view, {{"http://h/none"}}, RdfSyntax::kNTriples), "");
}

TEST(RdfSyntaxes, AreKnownByNameAndSuffix) {
  for (const RdfSyntaxName& syntax : RdfSyntaxes()) {
    EXPECT_EQ(SyntaxNamed(syntax.name), &syntax);
    EXPECT_EQ(SyntaxOfPath(std::string("/a.b/facts") + syntax.suffix), &syntax);
  }
  EXPECT_EQ(SyntaxOfPath("FACTS.TTL"), SyntaxNamed("turtle"));
  EXPECT_EQ(SyntaxOfPath("facts.rdf"), nullptr);
  EXPECT_EQ(SyntaxNamed("Turtle"), nullptr);
}

// https://www.w3.org/TR/trig/#sec-trig-intro
TEST(TriG, ReadsEveryFormOfGraph) {
  const Statements want = {
      {Ex("a"), Ex("p"), Ex("o1"), Iri(kDefault)},
      {Ex("a"), Ex("p"), Ex("o2"), Iri(kDefault)},
      {Ex("a"), Ex("p"), Ex("o3"), Ex("g")},
      {Ex("b"), Ex("p"), Ex("o4"), Ex("g")},
      {Ex("a"), Ex("p"), Ex("o5"), Iri("http://h/base/g2")},
      {Ex("a"), Ex("p"), Ex("o6"), Blank("g3")},
      {Ex("a"), Ex("p"), Blank("g3"), Blank("g4")},
  };
  EXPECT_TRUE(IsIsomorphic(
      Read("@base <http://h/base/> . ex:a ex:p ex:o1 .\n"
           "{ ex:a ex:p ex:o2 }\nex:g { ex:a ex:p ex:o3 . ex:b ex:p ex:o4 . }\n"
           "GRAPH <g2> { ex:a ex:p ex:o5 } _:g3 { ex:a ex:p ex:o6 }\n"
           "[] { ex:a ex:p _:g3 } ex:empty { }",
           RdfSyntax::kTriG),
      want));
}

TEST(TriG, ALabelIsOneNodeInAllGraphs) {
  const Statements statements =
      Read("ex:g { _:b1 ex:p [] } ex:h { _:b1 ex:p ( 1 ) } _:b2 ex:p _:b1 .",
           RdfSyntax::kTriG);
  std::set<Term> blanks;
  for (const Statement& s : statements) {
    blanks.insert(s.subject);
    if (s.object.is_blank()) blanks.insert(s.object);
  }
  EXPECT_EQ(blanks.size(), 4u);
}

TEST(NQuads, ReadsTheFormsOfTheRecommendation) {
  const Statements statements = Read(
      "# a note\n\n<http://h/s> <http://h/p> \"\\u00e9\\n\\\"\"@EN "
      "<http://h/g> "
      ".\n_:a <http://h/p> _:b _:g . # end\r\n"
      "<http://h/s><http://h/p>\"1\"^^<http://h/t>.\n"
      "_:a.b <http://h/p> \"it's\" .",
      RdfSyntax::kNQuads);
  ASSERT_EQ(statements.size(), 4u);
  EXPECT_EQ(statements[0].object, LanguageLiteral("\u00e9\n\"", "en"));
  EXPECT_EQ(statements[0].graph, Iri("http://h/g"));
  EXPECT_TRUE(statements[1].graph.is_blank());
  EXPECT_EQ(statements[2].object, Literal("1", "http://h/t"));
  EXPECT_EQ(statements[3].graph, Iri(kDefault));
}

TEST(NTriples, RefusesWhatOnlyTurtleHas) {
  const char* kBad[] = {
      "ex:a <http://h/p> <http://h/o> .",
      "<http://h/s> a <http://h/o> .",
      "<http://h/s> <http://h/p> 1 .",
      "<http://h/s> <http://h/p> true .",
      "<http://h/s> <http://h/p> [] .",
      "<http://h/s> <http://h/p> (1) .",
      "<http://h/s> <http://h/p> 'x' .",
      "<http://h/s> <http://h/p> \"\"\"x\"\"\" .",
      "<http://h/s> <http://h/p> \"x\" , \"y\" .",
      "<http://h/s> <http://h/p> \"x\" ; <http://h/q> \"y\" .",
      "<http://h/s> <http://h/p> \"x\"",
      "<http://h/s> <http://h/p> \"x\" <http://h/g> .",
      "<http://h/s>\n<http://h/p> \"x\" .",
      "<http://h/s> <http://h/p> \"x\" . <http://h/s> <http://h/p> \"y\" .",
      "<s> <http://h/p> \"x\" .",
      "@prefix h: <http://h/> .",
      "\"s\" <http://h/p> \"x\" .",
      "<http://h/s> _:p \"x\" .",
      "<http://h/s> <http://h/p> \"x\"^^ex:t .",
      "<http://h/s> <http://h/p> \"a\nb\" .",
      "<http://h/s> <http://h/p> .",
  };
  for (const char* text : kBad) {
    EXPECT_THROW(Read(text, RdfSyntax::kNTriples), InputError) << text;
  }
  EXPECT_THROW(
      Read("<http://h/s> <http://h/p> \"x\" \"g\" .", RdfSyntax::kNQuads),
      InputError);
  EXPECT_THROW(
      Read("<http://h/s> <http://h/p> \"x\" <http://h/g> <http://h/g> .",
           RdfSyntax::kNQuads),
      InputError);
}

TEST(TriG, AnIntegerBeforeThePointIsAnInteger) {
  for (const char* text :
       {"ex:a ex:p 5.", "ex:g { ex:a ex:p 5. }", "ex:g { ex:a ex:p 5.}",
        "GRAPH ex:g { ex:a ex:p 5. ex:b ex:p 5.}", "{ ex:a ex:p 5 , 5.}"}) {
    const Statements statements = Read(text, RdfSyntax::kTriG);
    EXPECT_FALSE(statements.empty()) << text;
    for (const Statement& s : statements) {
      EXPECT_EQ(s.object, IntegerLiteral(5)) << text;
    }
  }
}

TEST(TriG, RemovesDotSegmentsOfGraphNames) {
  const Statements statements =
      Read("@base <http://h/a/b> . <c/../d> { <./e> ex:p <../f/.> . }",
           RdfSyntax::kTriG);
  ASSERT_EQ(statements.size(), 1u);
  EXPECT_EQ(statements[0].graph, Iri("http://h/a/d"));
  EXPECT_EQ(statements[0].subject, Iri("http://h/a/e"));
  EXPECT_EQ(statements[0].object, Iri("http://h/f/"));
}

TEST(TriG, RefusesWhatIsNoTriG) {
  const char* kBad[] = {"ex:g { ex:a ex:p 1",
                        "ex:g { { ex:a ex:p 1 } }",
                        "ex:g { ex:a ex:p }",
                        "ex:a ex:p 1 }",
                        "ex:g ex:h { ex:a ex:p 1 }",
                        "GRAPH { ex:a ex:p 1 }",
                        "\"g\" { ex:a ex:p 1 }",
                        "ex:g { ex:a ex:p 1 . . }",
                        "ex:g { @prefix f: <http://f/> . }",
                        "( 1 ) { ex:a ex:p 1 }",
                        "ex:g { ex:a ex:p 1 } ."};
  for (const char* text : kBad) {
    EXPECT_THROW(Read(text, RdfSyntax::kTriG), InputError) << text;
  }
}

TEST(RdfSyntaxes, NameThePlaceOfAnErrorInOneLine) {
  EXPECT_EQ(GetError("ex:g {\n  ex:a foaf:p 1 }", RdfSyntax::kTriG),
            "facts:2:8: unknown prefix 'foaf:'; expected one declared with "
            "@prefix, or one of ours");
  EXPECT_EQ(GetError("<http://h/s> <http://h/p> ex:o .", RdfSyntax::kNTriples),
            "facts:1:27: expected an IRI in angles, a blank node, a literal or "
            "a point");
  EXPECT_EQ(GetError("<http://h/s> <http://h/p>\n", RdfSyntax::kNQuads),
            "facts:1:26: expected a point before the end of the line");
  EXPECT_EQ(GetError("_:b1 ex:p _:b2 .\n_:b3 3 4 .", RdfSyntax::kTriG)
                .rfind("facts:2:6: ", 0),
            0u)
      << GetError("_:b1 ex:p _:b2 .\n_:b3 3 4 .", RdfSyntax::kTriG);
}

TEST(RdfSyntaxes, RefuseDepthAndSizeBeforeReading) {
  const std::string deep = "ex:g { ex:a ex:p " + std::string(50000, '(');
  EXPECT_THROW(Read(deep, RdfSyntax::kTriG), InputError);
  EXPECT_THROW(Read(std::string(50000, '{'), RdfSyntax::kTriG), InputError);
  for (const RdfSyntaxName& syntax : RdfSyntaxes()) {
    EXPECT_THROW(Read("# longer", syntax.syntax, {5, 200}), InputError);
    EXPECT_TRUE(Read("# as long", syntax.syntax, {9, 200}).empty());
  }
}

TEST(RdfSyntaxes, ReadMutatedTextOrRefuseItNeverWorse) {
  const std::string good =
      "_:b1 ex:p [ ex:q ( 1 'a'@en ) ] . GRAPH ex:g { ex:a a ex:C . _:b1 ex:p "
      "\"\"\"x\"\"\"^^xsd:string, 4e1 } { <http://h/k#l> ex:p true . } # end\n"
      "<http://h/s> <http://h/p> \"x\\n\"@en <http://h/g> .\n";
  std::mt19937 random(11);
  for (int i = 0; i < 20000; ++i) {
    std::string text = good.substr(random() % good.size());
    for (int changes = 1 + random() % 3; changes > 0; --changes) {
      text[random() % text.size()] = static_cast<char>(random());
    }
    const RdfSyntaxName& syntax = PickOne(RdfSyntaxes(), random);
    try {
      Read(text.substr(0, random() % (text.size() + 1)), syntax.syntax);
    } catch (const InputError& error) {
      const std::string what = error.what();
      ASSERT_EQ(what.rfind("facts:", 0), 0u) << what;
      ASSERT_EQ(what.find('\n'), std::string::npos) << what;
    }
  }
}

TEST(RdfSyntaxes, ABaseIsWhatRelativeIrisAreRelativeTo) {
  const Statements statements =
      ParseRdf("<a> ex:p <../b>, <#c>, <> .", RdfSyntax::kTurtle,
               {"facts", Iri(kDefault), "http://h/x/y"});
  ASSERT_EQ(statements.size(), 3u);
  EXPECT_EQ(statements[0].subject, Iri("http://h/x/a"));
  EXPECT_EQ(statements[0].object, Iri("http://h/b"));
  EXPECT_EQ(statements[1].object, Iri("http://h/x/y#c"));
  EXPECT_EQ(statements[2].object, Iri("http://h/x/y"));
}

TEST(RdfFile, IsReadBySuffix) {
  const kg_base::TemporaryFolder folder;
  std::ofstream(folder / "a.nq")
      << "<http://h/s> <http://h/p> \"x\" <http://h/g> .\n";
  std::ofstream(folder / "a.csv") << "x\n";
  const Statements statements = ParseRdfFile(folder / "a.nq", Iri(kDefault));
  ASSERT_EQ(statements.size(), 1u);
  EXPECT_EQ(statements[0].graph, Iri("http://h/g"));
  EXPECT_THROW(ParseRdfFile(folder / "a.csv", Iri(kDefault)), InputError);
  EXPECT_THROW(ParseRdfFile(folder / "none.ttl", Iri(kDefault)), InputError);
}

}  // namespace
}  // namespace kg_core
