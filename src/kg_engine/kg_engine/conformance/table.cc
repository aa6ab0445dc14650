// Markdown tables of outcomes for the documentation.

#include <map>
#include <string>

#include "kg_engine/conformance/conformance.h"

namespace kg_engine {
namespace {

using Outcome = ConformanceTest::Outcome;
using Tests = std::vector<ConformanceTest>;

// Escapes text for a one-line table cell.
std::string FormatCell(const std::string& text) {
  std::string cell;
  for (const char c : text) {
    if (c == '|') cell += '\\';
    cell += c;
  }
  return cell;
}

const char* GetWord(Outcome outcome) {
  switch (outcome) {
    case Outcome::kPassed:
      return "passed";
    case Outcome::kFailed:
      return "**failed**";
    case Outcome::kDeviates:
      return "deviates";
    case Outcome::kNotRun:
      return "not run";
  }
  return "";
}

std::string FormatCounts(const std::string& group, const Tests& tests) {
  const ConformanceCount count = CountOutcomes(tests);
  std::string row = "| " + FormatCell(group) + " |";
  for (const std::size_t number :
       {tests.size(), static_cast<std::size_t>(count.passed),
        static_cast<std::size_t>(count.deviating),
        static_cast<std::size_t>(count.not_run),
        static_cast<std::size_t>(count.failed)}) {
    row += " " + std::to_string(number) + " |";
  }
  return row + "\n";
}

}  // namespace

std::string ConformanceTable(const Tests& tests) {
  std::map<std::string, Tests> groups;
  for (const ConformanceTest& test : tests) groups[test.group].push_back(test);
  std::string text =
      "| group | tests | passed | deviate | not run | failed |\n"
      "|---|---|---|---|---|---|\n";
  for (const auto& [group, members] : groups) {
    text += FormatCounts(group, members);
  }
  text += FormatCounts("all", tests) +
          "\n## Tests that have not passed\n\n"
          "| group | test | outcome | reason |\n|---|---|---|---|\n";
  for (const auto& [group, members] : groups) {
    for (const ConformanceTest& test : members) {
      if (test.outcome == Outcome::kPassed) continue;
      text += "| " + FormatCell(group) + " | " + FormatCell(test.name) + " | " +
              GetWord(test.outcome) + " | " + FormatCell(test.message) + " |\n";
    }
  }
  return text;
}

}  // namespace kg_engine
