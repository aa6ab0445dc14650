// Tests of the RDF syntaxes: Turtle, TriG, N-Triples, N-Quads.
// https://www.w3.org/2013/TurtleTests/, TriGTests/, N-TriplesTests/,
// N-QuadsTests/

#include <filesystem>
#include <utility>

#include "kg_base/common/input_error.h"
#include "kg_core/rdf/syntax.h"
#include "kg_engine/conformance/result_set.h"
#include "kg_engine/conformance/test_case.h"

namespace kg_engine::conformance {
namespace {

using kg_core::Iri;
using kg_core::RdfSyntax;
using kg_core::Statement;

using Statements = std::vector<Statement>;

struct TestedSyntax {
  const char* kind;  // First part of the kind of test.
  RdfSyntax syntax;
  const char* home;  // Relative IRIs of the tests are relative to it.
};
constexpr TestedSyntax kTestedSyntaxes[] = {
    {"TestTurtle", RdfSyntax::kTurtle, "http://www.w3.org/2013/TurtleTests/"},
    {"TestTrig", RdfSyntax::kTriG, "http://www.w3.org/2013/TriGTests/"},
    {"TestNTriples", RdfSyntax::kNTriples, ""},
    {"TestNQuads", RdfSyntax::kNQuads, ""},
};

const TestedSyntax& FindSyntax(const TestCase& test) {
  for (const TestedSyntax& syntax : kTestedSyntaxes) {
    if (test.kind.rfind(syntax.kind, 0) == 0) return syntax;
  }
  throw NotRun("no test of an RDF syntax that is read here");
}

// The IRI from which the tested file would be retrieved.
std::string GetBase(const TestCase& test, const TestedSyntax& syntax,
                    const std::string& url) {
  const std::string home = syntax.home;
  const std::string name = std::filesystem::path(url).filename();
  const auto base =
      test.One(Iri(test.manifest), std::string(kMf) + "assumedTestBase");
  if (base) return base->text + name;
  return home.empty() ? "" : home + name;
}

// Texts have no NUL here, so a good text with one cannot be read.
void RefuseNul(const TestCase& test) {
  if (GetText(test.Action().text).find('\0') == std::string::npos) return;
  throw NotRun("needs the character NUL, which is not supported");
}

Statements ParseAction(const TestCase& test) {
  const TestedSyntax& syntax = FindSyntax(test);
  const std::string url = test.Action().text;
  return kg_core::ParseRdf(
      GetText(url), syntax.syntax,
      {PathOfUrl(url), Iri(kDefaultGraph), GetBase(test, syntax, url)});
}

// What comes back of the statements after a store and a text in the tested
// syntax, so that writers are tested, too.
Statements ThroughStore(const TestCase& test, const Statements& statements) {
  kg_core::Store store("");
  kg_core::Transaction change = store.Begin();
  for (const Statement& statement : statements) change.Add(statement);
  const kg_core::RdfSelection all{kg_core::ListGraphs(change.view()),
                                  kDefaultGraph};
  const RdfSyntax syntax = FindSyntax(test).syntax;
  return kg_core::ParseRdf(kg_core::WriteRdf(change.view(), all, syntax),
                           syntax, {"export", Iri(kDefaultGraph)});
}

}  // namespace

std::string RunRdfEvaluationTest(const TestCase& test) {
  RefuseNul(test);
  const Statements got = ParseAction(test);
  const std::string difference =
      Difference(got, CollectStatements(test.Result().text, kDefaultGraph));
  return difference.empty() ? Difference(ThroughStore(test, got), got)
                            : difference;
}

std::string RunRdfPositiveSyntaxTest(const TestCase& test) {
  RefuseNul(test);
  const Statements got = ParseAction(test);
  return Difference(ThroughStore(test, got), got);
}

std::string RunRdfNegativeSyntaxTest(const TestCase& test) {
  GetText(test.Action().text);  // A missing file is not a syntax error.
  try {
    ParseAction(test);
  } catch (const kg_base::InputError&) {
    return "";
  }
  return "was read, but is not of the syntax";
}

}  // namespace kg_engine::conformance
