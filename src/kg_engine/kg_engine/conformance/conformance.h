// Runs W3C test suites from folders: SPARQL query and update (evaluation,
// syntax, result formats) and SHACL.
//
//   for (const ConformanceTest& test : RunConformance("data-sparql11")) ...
//
// A suite is data: manifests in Turtle name queries, graphs and what is to come
// of them. https://www.w3.org/2001/sw/DataAccess/tests/README
// https://www.w3.org/2009/sparql/docs/tests/
// https://w3c.github.io/data-shapes/data-shapes-test-suite/
// Nothing is fetched. What needs the network, an entailment regime or a server
// is listed as not run with the reason, never as passed.

#ifndef KG_ENGINE_CONFORMANCE_CONFORMANCE_H_
#define KG_ENGINE_CONFORMANCE_CONFORMANCE_H_

#include <string>
#include <vector>

#include "absl/functional/function_ref.h"

namespace kg_engine {

struct ConformanceTest {
  enum class Outcome { kPassed, kFailed, kNotRun };
  // The manifest's folder, relative to the folder that is run.
  std::string group;
  std::string name;  // Last part of its IRI, or mf:name.
  std::string iri;
  std::string kind;  // "QueryEvaluationTest", "Validate", ...
  Outcome outcome = Outcome::kFailed;
  std::string message{};  // One line: the difference, or why it was not run.
};

// Runs every test of every manifest below `folder` (files manifest*.ttl and
// what they include, each once; sorted), or of the one manifest file `folder`,
// and calls `done` after each. Throws InputError if there is no manifest.
std::vector<ConformanceTest> RunConformance(
    const std::string& folder,
    absl::FunctionRef<void(const ConformanceTest&)> done =
        [](const ConformanceTest&) {});

struct ConformanceCount {
  int passed = 0;
  int failed = 0;
  int not_run = 0;
};
ConformanceCount CountOutcomes(const std::vector<ConformanceTest>& tests);

// Markdown table of the tests by group, followed by counts. Deterministic.
std::string ConformanceTable(const std::vector<ConformanceTest>& tests);

}  // namespace kg_engine

#endif  // KG_ENGINE_CONFORMANCE_CONFORMANCE_H_
