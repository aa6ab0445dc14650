#include "kg_core/sparql/results.h"

#include <gtest/gtest.h>

#include <string>

#include "kg_core/rdf/namespaces.h"

namespace kg_core {
namespace {

QueryResult Example() {
  QueryResult result;
  result.variables = {"agent", "note"};
  result.rows = {{Iri(std::string(kEx) + "alpha"), IntegerLiteral(3)},
                 {Blank("b"), LanguageLiteral("say \"h\xC3\xA9\"\n", "fr")},
                 {std::nullopt, Literal("x")}};
  return result;
}

TEST(Results, WritesTheStandardJson) {
  EXPECT_EQ(
      ToJson(Example()),
      "{\"head\":{\"vars\":[\"agent\",\"note\"]},\"results\":{\"bindings\":[\n"
      "{\"agent\":{\"type\":\"uri\",\"value\":\"http://example.org/mission/"
      "alpha\"},\"note\":{\"type\":\"literal\",\"datatype\":\"http://"
      "www.w3.org/2001/XMLSchema#integer\",\"value\":\"3\"}},\n"
      "{\"agent\":{\"type\":\"bnode\",\"value\":\"b\"},\"note\":{\"type\":"
      "\"literal\",\"xml:lang\":\"fr\",\"value\":\"say "
      "\\\"h\xC3\xA9\\\"\\u000a\"}},\n"
      "{\"note\":{\"type\":\"literal\",\"value\":\"x\"}}]}}");
}

TEST(Results, WritesATableThatLinesUp) {
  EXPECT_EQ(ToTextTable(Example()),
            "?agent    ?note\n"
            "--------  -----------------\n"
            "ex:alpha  3\n"
            "_:b       \"say \\\"h\xC3\xA9\\\"\\n\"@fr\n"
            "          \"x\"\n"
            "3 rows\n");
}

TEST(Results, WritesTheStandardXml) {
  EXPECT_EQ(ToXml(Example()),
            "<?xml version=\"1.0\"?>\n"
            "<sparql xmlns=\"http://www.w3.org/2005/sparql-results#\">\n"
            "<head><variable name=\"agent\"/><variable name=\"note\"/></head>\n"
            "<results>\n"
            "<result><binding name=\"agent\"><uri>http://example.org/mission/"
            "alpha</uri></binding><binding name=\"note\"><literal datatype=\""
            "http://www.w3.org/2001/XMLSchema#integer\">3</literal></binding>"
            "</result>\n"
            "<result><binding name=\"agent\"><bnode>b</bnode></binding>"
            "<binding name=\"note\"><literal xml:lang=\"fr\">say &quot;h"
            "\xC3\xA9&quot;\n</literal></binding></result>\n"
            "<result><binding name=\"note\"><literal>x</literal></binding>"
            "</result>\n"
            "</results>\n</sparql>\n");
}

TEST(Results, WritesTheStandardCsvAndTsv) {
  EXPECT_EQ(ToCsv(Example()),
            "agent,note\r\nhttp://example.org/mission/alpha,3\r\n"
            "_:b,\"say \"\"h\xC3\xA9\"\"\n\"\r\n,x\r\n");
  EXPECT_EQ(ToTsv(Example()),
            "?agent\t?note\n<http://example.org/mission/alpha>\t\"3\"^^"
            "<http://www.w3.org/2001/XMLSchema#integer>\n"
            "_:b\t\"say \\\"h\xC3\xA9\\\"\\n\"@fr\n\t\"x\"\n");
}

TEST(Results, ListsItsFormats) {
  for (const ResultFormat& format : ResultFormats()) {
    EXPECT_FALSE(format.write(Example()).empty()) << format.name;
  }
}

QueryResult Graph() {
  QueryResult result;
  result.form = QueryResult::Form::kConstruct;
  const Term alpha = Iri(std::string(kEx) + "alpha");
  const Term type = Iri(std::string(kRdf) + "type");
  result.triples = {{alpha, Iri("http://other/p"), Literal("x y")},
                    {alpha, type, Iri(std::string(kEx) + "Agent")},
                    {alpha, Iri("http://other/p"), Blank("b")}};
  return result;
}

TEST(Results, WritesTriplesAsTurtleWithThePrefixesUsed) {
  const std::string turtle =
      "@prefix ex: <http://example.org/mission/> .\n"
      "@prefix rdf: <http://www.w3.org/1999/02/22-rdf-syntax-ns#> .\n"
      "@prefix xsd: <http://www.w3.org/2001/XMLSchema#> .\n"
      "\nex:alpha <http://other/p> \"x y\", _:b ;\n    a ex:Agent .\n";
  EXPECT_EQ(TriplesToTurtle(Graph().triples), turtle);
  EXPECT_EQ(ToTextTable(Graph()), turtle);
  EXPECT_EQ(TriplesToTurtle({}), "");
}

TEST(Results, WritesTriplesAsRowsWhereThereIsNoOtherForm) {
  EXPECT_EQ(AsRows(Graph()).rows.size(), 3u);
  EXPECT_EQ(ToJson(Graph()), ToJson(AsRows(Graph())));
}

TEST(Results, WritesTheAnswerOfAsk) {
  QueryResult result;
  result.form = QueryResult::Form::kAsk;
  result.answer = true;
  EXPECT_EQ(ToJson(result), "{\"head\":{},\"boolean\":true}");
  EXPECT_EQ(ToTextTable(result), "yes\n");
}

TEST(Results, XmlHoldsNoCharactersThatItMayNot) {
  QueryResult result;
  result.variables = {"x"};
  result.rows = {
      {Literal("a\xEF\xBF\xBE"
               "b\xEF\xBF\xBF\x01\xEF\xBF\xBD")}};
  const std::string replaced = "\xEF\xBF\xBD";
  EXPECT_NE(ToXml(result).find("<literal>a" + replaced + "b" + replaced +
                               replaced + replaced + "</literal>"),
            std::string::npos)
      << ToXml(result);
}

}  // namespace
}  // namespace kg_core
