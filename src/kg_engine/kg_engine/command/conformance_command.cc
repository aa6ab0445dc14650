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

void WriteTable(const std::string& file,
                const std::vector<ConformanceTest>& tests) {
  std::ofstream out(file, std::ios::binary);
  out << "# Conformance\n\nEvery test of the W3C suites shipped next to the "
         "project, made by `kg conformance --table`.\n\n"
      << kg_engine::ConformanceTable(tests);
  out.close();
  if (!out) throw kg_base::InputError(file + ": cannot be written");
}

int RunConformance(const Arguments& arguments) {
  arguments.ExpectWords(1, 1000, "at least one FOLDER");
  std::vector<ConformanceTest> tests;
  for (const std::string& folder : arguments.words) {
    const auto more = kg_engine::RunConformance(folder, Show);
    tests.insert(tests.end(), more.begin(), more.end());
  }
  if (const auto file = arguments.One("--table")) WriteTable(*file, tests);
  const kg_engine::ConformanceCount count = kg_engine::CountOutcomes(tests);
  if (count.not_run > 0) std::cout << count.not_run << " not run\n";
  std::cout << count.passed << " passed, " << count.failed << " failed\n";
  return count.failed == 0 && count.passed > 0 ? kDone : kRefused;
}

}  // namespace

const Subcommand kConformance = {
    "conformance",
    "FOLDER... [--table FILE]",
    "run W3C test suites: SPARQL query, update, syntax, results; SHACL Core",
    "Runs every manifest*.ttl below each FOLDER and prints a line a test. "
    "What\n"
    "needs the network, a server or an entailment regime is not run, and "
    "counted\n"
    "apart. The last line is `N passed, N failed`; status 1 if one failed or\n"
    "none passed.\n\n"
    "  --table FILE  also write the outcomes as a table in Markdown\n",
    {{"--table", true}},
    RunConformance};

}  // namespace kg_engine::command
