#include "kg_core/rdf/term_check.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "kg_base/common/input_error.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_core/rdf/store.h"
#include "kg_core/rdf/syntax.h"
#include "kg_core/sparql/isomorphism.h"

namespace kg_core {
namespace {

using kg_base::InputError;
using Statements = std::vector<Statement>;

const char kHalf[] = "\xED\xA0\x80";  // U+D800 as three bytes.

std::vector<Term> InvalidTerms() {
  std::vector<Term> terms = {
      Iri(""),
      Iri("a"),
      Iri("../a"),
      Iri("//host/a"),
      Iri("1a:b"),
      Iri(":a"),
      Iri(std::string("http://h/") + kHalf),
      Iri("http://h/\xC3"),
      Literal("x", "dt"),
      Literal("x", ""),
      Literal("x", "http://h/a b"),
      Literal("x", std::string(kRdf) + "langString"),
      Literal(std::string("a") + kHalf),
      Literal("\xFF"),
      LanguageLiteral(kHalf, "en"),
  };
  for (const char c : std::string(" <>\"{}|^`\\\n\t\x01\x1F") + '\0') {
    terms.push_back(Iri(std::string("http://h/a") + c));
    terms.push_back(Literal("x", std::string("http://h/a") + c));
  }
  for (const char* language : {"-", "en-", "-en", "en--gb", "e n", "1", "e1",
                               "en_gb", "\xC3\xA9", "en-\xC3\xA9"}) {
    terms.push_back(LanguageLiteral("x", language));
  }
  return terms;
}

std::vector<Term> ValidTerms() {
  return {Iri("http://h/"),
          Iri("urn:a"),
          Iri("a+b-c.1:"),
          Iri("mailto:a@b"),
          Iri("http://h/a%20b?c#d"),
          Iri("http://h/\xC3\xA9\xF0\x9F\x98\x80"),
          Iri("http://h/[1]'()!$&*+,;=~"),
          Literal(""),
          Literal("a\x01\x7F\n\xEF\xBF\xBE"),
          Literal("x", "urn:t"),
          LanguageLiteral("", "en"),
          LanguageLiteral("x", "EN-gb"),
          LanguageLiteral("x", "zh-hans-x-old1")};
}

// The statement with `term` in each place where it may stand.
Statements StatementsWith(const Term& term) {
  const Term other = Iri("http://h/o");
  if (!term.is_iri()) return {{other, other, term, other}};
  return {{term, other, other, other},
          {other, term, other, other},
          {other, other, term, other},
          {other, other, other, term}};
}

Statements GetContent(const GraphView& view) {
  Statements all;
  view.Match({}, [&](const Quad& q) {
    all.push_back({view.Get(q.subject), view.Get(q.predicate),
                   view.Get(q.object), view.Get(q.graph)});
    return true;
  });
  return all;
}

TEST(TermCheck, StoreRefusesTermsThatAreNoRdf) {
  for (const Term& term : InvalidTerms()) {
    for (const Statement& statement : StatementsWith(term)) {
      Store store("");
      Transaction change = store.Begin();
      EXPECT_THROW(change.Add(statement), InputError) << ToNTriples(term);
      EXPECT_TRUE(change.empty());
      change.Commit(WorldChange::kYes);
      EXPECT_EQ(store.term_count(), 0u) << ToNTriples(term);
    }
  }
}

TEST(TermCheck, WhatIsStoredIsReadAgainInEachSyntax) {
  Store store("");
  Transaction change = store.Begin();
  for (const Term& term : ValidTerms()) {
    for (const Statement& statement : StatementsWith(term)) {
      change.Add(statement);
    }
  }
  const Statements content = GetContent(change.view());
  RdfSelection all;
  all.graphs = ListGraphs(change.view());
  for (const RdfSyntaxName& syntax : RdfSyntaxes()) {
    if (!syntax.has_graphs) continue;
    const std::string text = WriteRdf(change.view(), all, syntax.syntax);
    EXPECT_TRUE(IsIsomorphic(
        ParseRdf(text, syntax.syntax, {"text", Iri("http://h/none")}), content))
        << text;
  }
}

TEST(TermCheck, FilesWithTermsThatAreNoRdfAreRefused) {
  const std::pair<const char*, const char*> kTerms[] = {
      {"\"\\uD800\"", "surrogate"},
      {"\"\\uDFFF\"", "surrogate"},
      {"\"a\\U0000DC00\"@en", "surrogate"},
      {"<http://h/\\uD83D>", "surrogate"},
      {"<http://h/\\u0020>", "U+0020"},
      {"<http://h/\\u003C>", "U+003C"},
      {"\"x\"^^<http://h/\\u007D>", "U+007D"},
      {"\"x\"@en-", "en-"},
  };
  for (const auto& [term, cause] : kTerms) {
    for (const RdfSyntaxName& syntax : RdfSyntaxes()) {
      const std::string text =
          "<http://h/s> <http://h/p>\n " + std::string(term) + " .\n";
      const bool is_line = syntax.syntax == RdfSyntax::kNTriples ||
                           syntax.syntax == RdfSyntax::kNQuads;
      std::string line = text;
      if (is_line) line.replace(line.find('\n'), 1, " ");
      try {
        ParseRdf(line, syntax.syntax, {"facts", Iri("http://h/g")});
        ADD_FAILURE() << syntax.name << ": " << line;
      } catch (const InputError& error) {
        const std::string what = error.what();
        EXPECT_NE(what.find(cause), std::string::npos) << what;
        EXPECT_EQ(what.rfind(is_line ? "facts:1:" : "facts:2:", 0), 0u) << what;
      }
    }
  }
}

TEST(TermCheck, LanguageTagsFollowTheGrammar) {
  for (const char* tag : {"en", "EN", "a-b", "de-1996", "x-y-z1"}) {
    EXPECT_TRUE(IsLanguageTag(tag)) << tag;
  }
  for (const char* tag :
       {"", "-", "e1", "en-", "-en", "en--x", "en-\xC3\xA9"}) {
    EXPECT_FALSE(IsLanguageTag(tag)) << tag;
  }
}

}  // namespace
}  // namespace kg_core
