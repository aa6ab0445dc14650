// Markdown table of outcomes for the documentation.

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

std::string FormatResult(const ConformanceTest& test) {
  switch (test.outcome) {
    case Outcome::kPassed:
      return "passed";
    case Outcome::kFailed:
      return "**failed**: " + FormatCell(test.message);
    case Outcome::kNotRun:
      return "not run: " + FormatCell(test.message);
  }
  return "";
}

std::string FormatCounts(const Tests& tests) {
  const ConformanceCount count = CountOutcomes(tests);
  std::string text = std::to_string(count.passed) + " passed, " +
                     std::to_string(count.failed) + " failed";
  if (count.not_run > 0) {
    text += ", " + std::to_string(count.not_run) + " not run";
  }
  return text;
}

}  // namespace

std::string ConformanceTable(const Tests& tests) {
  std::map<std::string, Tests> groups;
  for (const ConformanceTest& test : tests) groups[test.group].push_back(test);
  std::string text;
  for (const auto& [group, members] : groups) {
    text += "## " + group + "\n\n" + FormatCounts(members) +
            "\n\n| test | kind | result |\n|---|---|---|\n";
    for (const ConformanceTest& test : members) {
      text += "| " + FormatCell(test.name) + " | " + test.kind + " | " +
              FormatResult(test) + " |\n";
    }
    text += "\n";
  }
  return text + FormatCounts(tests) + "\n";
}

}  // namespace kg_engine
