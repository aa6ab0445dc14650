// Runs W3C test suites from folders: SPARQL query and update (evaluation,
// syntax, result formats, protocol), SHACL, Turtle, TriG, N-Triples and
// N-Quads.
//
//   for (const ConformanceTest& test : RunConformance("data-sparql11")) ...
//
// A suite is data: manifests in Turtle name queries, graphs and what is to come
// of them. https://www.w3.org/2001/sw/DataAccess/tests/README
// https://www.w3.org/2009/sparql/docs/tests/
// https://w3c.github.io/data-shapes/data-shapes-test-suite/
// Nothing is fetched. What needs the network, an entailment regime, a server or
// the character NUL, and what the working group has withdrawn, is listed as not
// run with the reason, never as passed.

#ifndef KG_ENGINE_CONFORMANCE_CONFORMANCE_H_
#define KG_ENGINE_CONFORMANCE_CONFORMANCE_H_

#include <map>
#include <string>
#include <vector>

#include "absl/functional/function_ref.h"

namespace kg_engine {

struct ConformanceTest {
  enum class Outcome {
    kPassed,
    kFailed,
    kDeviates,  // Fails for the reason stated in a list of deviations.
    kNotRun,
  };
  // The manifest's folder, relative to the folder that is run.
  std::string group;
  std::string name;  // Last part of its IRI, or mf:name.
  std::string iri;
  std::string kind;  // "QueryEvaluationTest", "Validate", ...
  Outcome outcome = Outcome::kFailed;
  std::string message{};  // One line: the difference, or the reason.
};

// Reasons why tests fail, by the IRIs of the tests.
using KnownDeviations = std::map<std::string, std::string>;

// Reads a file with a test's IRI, a space and the reason in each line; empty
// lines and lines from '#' are comments. Throws InputError.
KnownDeviations ReadDeviations(const std::string& path);

// Runs every test of every manifest below `folder` (files manifest*.ttl and
// what they include, each once; sorted), or of the one manifest file `folder`,
// and calls `done` after each. A test that passes in spite of a known deviation
// has failed: the list is wrong. Throws InputError if there is no manifest.
std::vector<ConformanceTest> RunConformance(
    const std::string& folder,
    absl::FunctionRef<void(const ConformanceTest&)> done =
        [](const ConformanceTest&) {},
    const KnownDeviations& deviations = {});

struct ConformanceCount {
  int passed = 0;
  int failed = 0;
  int deviating = 0;
  int not_run = 0;
};
ConformanceCount CountOutcomes(const std::vector<ConformanceTest>& tests);

// Markdown: a table of counts by group, and a table of each test that has not
// passed, with the reason. Deterministic.
std::string ConformanceTable(const std::vector<ConformanceTest>& tests);

}  // namespace kg_engine

#endif  // KG_ENGINE_CONFORMANCE_CONFORMANCE_H_
