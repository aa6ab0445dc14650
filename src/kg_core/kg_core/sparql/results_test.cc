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

}  // namespace
}  // namespace kg_core
