#include "kg_core/sparql/read_results.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "kg_base/common/input_error.h"
#include "kg_base/text/json.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_core/sparql/results.h"

namespace kg_core {
namespace {

using kg_base::InputError;

// Random text with characters that the formats must escape.
std::string RandomText(std::mt19937* random) {
  const std::string kPieces[] = {
      "a", ",", "\"", "\n",  "\r",       "\t",
      "<", "&", "\\", "]]>", "\xC3\xA9", " ",
      "'", ">", "?",  "{",   "_:b1",     "\xF0\x9F\x8C\x8A"};
  std::string text;
  for (std::size_t n = (*random)() % 8; n > 0; --n) {
    text += kPieces[(*random)() % std::size(kPieces)];
  }
  return text;
}

std::optional<Term> RandomTerm(std::mt19937* random) {
  switch ((*random)() % 6) {
    case 0:
      return std::nullopt;
    case 1:
      return Iri("http://x/y?a=1&b=" + std::to_string((*random)() % 9));
    case 2:
      return Blank("b" + std::to_string((*random)() % 9));
    case 3:
      return LanguageLiteral(RandomText(random), "en-gb");
    case 4:
      return Literal(RandomText(random), std::string(kXsd) + "decimal");
    default:
      return Literal(RandomText(random));
  }
}

QueryResult RandomResult(std::mt19937* random) {
  QueryResult result;
  result.variables = {"a", "bc"};
  for (std::size_t n = (*random)() % 5; n > 0; --n) {
    result.rows.push_back({RandomTerm(random), RandomTerm(random)});
  }
  return result;
}

TEST(ReadResults, ReadsWhatIsWritten) {
  std::mt19937 random(11);
  for (int round = 0; round < 1000; ++round) {
    const QueryResult result = RandomResult(&random);
    for (const QueryResult& back :
         {ReadJsonResult(ToJson(result)), ReadXmlResult(ToXml(result)),
          ReadTsvResult(ToTsv(result))}) {
      EXPECT_EQ(back.variables, result.variables);
      EXPECT_EQ(back.rows, result.rows);
    }
    // CSV keeps only the text and cannot distinguish "" from unbound.
    const QueryResult csv = ReadCsvResult(ToCsv(result));
    ASSERT_EQ(csv.rows.size(), result.rows.size());
    for (std::size_t i = 0; i < result.rows.size(); ++i) {
      for (std::size_t j = 0; j < 2; ++j) {
        const std::optional<Term>& term = result.rows[i][j];
        const std::string mark = term && term->is_blank() ? "_:" : "";
        EXPECT_EQ(csv.rows[i][j] ? csv.rows[i][j]->text : "",
                  term ? mark + term->text : "");
      }
    }
  }
}

TEST(ReadResults, ReadsTheAnswerOfAsk) {
  QueryResult ask;
  ask.form = QueryResult::Form::kAsk;
  for (const bool answer : {true, false}) {
    ask.answer = answer;
    EXPECT_EQ(ReadJsonResult(ToJson(ask)).answer, answer);
    EXPECT_EQ(ReadXmlResult(ToXml(ask)).answer, answer);
    EXPECT_EQ(ReadXmlResult(ToXml(ask)).form, QueryResult::Form::kAsk);
    EXPECT_EQ(ToCsv(ask),
              answer ? "answer\r\ntrue\r\n" : "answer\r\nfalse\r\n");
  }
}

TEST(ReadResults, ReadsXmlAsOthersWriteIt) {
  const QueryResult result = ReadXmlResult(
      "<?xml version='1.0'?><!-- by hand --><s:sparql "
      "xmlns:s='http://www.w3.org/2005/sparql-results#'><s:head>"
      "<s:variable name = 'x'/><s:link href='m'/></s:head><s:results ordered="
      "'true'><s:result>\n<s:binding name=\"x\"><s:literal xml:lang='EN'>"
      "<![CDATA[<b>]]>&#233;&#xe9;<!-- no --></s:literal></s:binding>"
      "</s:result><s:result/></s:results></s:sparql>");
  ASSERT_EQ(result.rows.size(), 2u);
  EXPECT_EQ(result.rows[0][0], LanguageLiteral("<b>\xC3\xA9\xC3\xA9", "en"));
  EXPECT_EQ(result.rows[1][0], std::nullopt);
}

TEST(ReadResults, ReadsEscapesOfJson) {
  EXPECT_EQ(kg_base::ParseJson("\"\\u00e9\\ud83c\\udf0a\\/\\n\"").text,
            "\xC3\xA9\xF0\x9F\x8C\x8A/\n");
  EXPECT_EQ(kg_base::ParseJson(" [1, -2.5e3 ,null,{}] ").items[1].text,
            "-2.5e3");
}

TEST(ReadResults, RefusesWhatIsNoResult) {
  for (const char* text :
       {"", "{", "[]", "{\"head\":{}}", "{\"head\":{\"vars\":[]}} x", "\"\\x\"",
        "\"\\ud800\"",
        "{\"head\":{\"vars\":[\"a\"]},\"results\":{\"bindings\":"
        "[{\"b\":{\"type\":\"uri\",\"value\":\"u\"}}]}}"}) {
    EXPECT_THROW(ReadJsonResult(text), InputError) << text;
  }
  for (const char* text :
       {"", "<html/>", "<sparql", "<!DOCTYPE a><sparql/>",
        "<sparql><result><binding name='x'><uri>u</uri></binding></result>",
        "<sparql a='&lol;'/>", "<sparql a='&#xD800;'/>"}) {
    EXPECT_THROW(ReadXmlResult(text), InputError) << text;
  }
  EXPECT_THROW(ReadCsvResult("a\r\n\"x\r\n"), InputError);
  EXPECT_THROW(ReadCsvResult("a,b\r\nx\r\n"), InputError);
  EXPECT_THROW(ReadTsvResult(""), InputError);
  EXPECT_THROW(ReadTsvResult("?a\n<x y>\n"), InputError);
  EXPECT_THROW(ReadJsonResult(std::string(200000, '[')), InputError);
}

}  // namespace
}  // namespace kg_core
