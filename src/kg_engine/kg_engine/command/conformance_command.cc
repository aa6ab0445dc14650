// kg conformance FOLDER...

#include <fstream>
#include <iostream>

#include "kg_base/common/input_error.h"
#include "kg_engine/command/command.h"
#include "kg_engine/conformance/conformance.h"

namespace kg_engine::command {
namespace {

using kg_engine::ConformanceTest;

const char* WordOf(ConformanceTest::Outcome outcome) {
  switch (outcome) {
    case ConformanceTest::Outcome::kPassed:
      return "passed  ";
    case ConformanceTest::Outcome::kFailed:
      return "FAILED  ";
    case ConformanceTest::Outcome::kDeviates:
      return "deviates ";
    case ConformanceTest::Outcome::kNotRun:
      return "not run ";
  }
  return "";
}

void Show(const ConformanceTest& test) {
  std::cout << WordOf(test.outcome) << test.group << " " << test.name << " ("
            << test.kind << ")"
            << (test.message.empty() ? "" : ": " + test.message) << std::endl;
}

constexpr char kTableHeader[] = R"md(# Conformance

The test suites of the W3C: SPARQL 1.0 and 1.1 (queries, updates, results, protocol), SHACL Core, Turtle, TriG,
N-Triples and N-Quads. Made by

    kg conformance ../shared/data/w3c src/kg_engine/test_data/w3c \
        --deviations src/kg_engine/test_data/w3c/deviations.txt --table docs/conformance.md

Not supported are the character NUL (RDF and SPARQL texts with one are refused), `SERVICE` (a query that uses it gets
one error; `SERVICE SILENT` has one solution without bindings), and entailment regimes. Tests of the Graph Store
Protocol have no manifest: `graph_store_test.cc` asks their requests.

)md";

void WriteTable(const std::string& file,
                const std::vector<ConformanceTest>& tests) {
  std::ofstream out(file, std::ios::binary);
  out << kTableHeader << kg_engine::ConformanceTable(tests);
  out.close();
  if (!out) throw kg_base::InputError(file + ": cannot be written");
}

int RunConformance(const Arguments& arguments) {
  arguments.ExpectWords(1, 1000, "at least one FOLDER");
  kg_engine::KnownDeviations deviations;
  if (const auto file = arguments.One("--deviations")) {
    deviations = kg_engine::ReadDeviations(*file);
  }
  std::vector<ConformanceTest> tests;
  for (const std::string& folder : arguments.words) {
    const auto more = kg_engine::RunConformance(folder, Show, deviations);
    tests.insert(tests.end(), more.begin(), more.end());
  }
  if (const auto file = arguments.One("--table")) WriteTable(*file, tests);
  const kg_engine::ConformanceCount count = kg_engine::CountOutcomes(tests);
  if (count.deviating > 0) std::cout << count.deviating << " deviate\n";
  if (count.not_run > 0) std::cout << count.not_run << " not run\n";
  std::cout << count.passed << " passed, " << count.failed << " failed\n";
  return count.failed == 0 && count.passed > 0 ? kDone : kRefused;
}

}  // namespace

const Subcommand kConformance = {
    "conformance",
    "FOLDER... [--deviations FILE] [--table FILE]",
    "run W3C test suites: SPARQL, SHACL Core, Turtle, TriG, N-Triples, N-Quads",
    "Runs every manifest*.ttl below each FOLDER and prints a line a test. "
    "What\n"
    "needs the network, a server or an entailment regime is not run, and "
    "counted\n"
    "apart. The last line is `N passed, N failed`; status 1 if one failed or\n"
    "none passed.\n\n"
    "  --deviations FILE  tests that fail for a reason: an IRI, a space and "
    "the\n"
    "                     reason in each line; counted apart\n"
    "  --table FILE  also write the outcomes as a table in Markdown\n",
    {{"--deviations", true}, {"--table", true}},
    RunConformance};

}  // namespace kg_engine::command
