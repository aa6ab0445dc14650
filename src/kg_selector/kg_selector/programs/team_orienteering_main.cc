// Runs the Team Orienteering benchmark with planner and selector. See --help.

#include <charconv>
#include <cmath>
#include <cstdio>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "kg_base/common/input_error.h"
#include "kg_base/common/join_strings.h"
#include "kg_selector/orienteering/top_report.h"
#include "kg_selector/team/team_modes.h"

namespace kg_selector {
namespace {

constexpr char kHelpBegin[] =
    R"(usage: team_orienteering FOLDER REFERENCE_FILE [--mode MODE] [--seconds S]

Plans every Team Orienteering instance of FOLDER (n, m, tmax, then x y score
lines; first point start, last end; each of m paths at most tmax, within 1e-9
for rounding; each score once) and compares with the values of REFERENCE_FILE
(lines of a file name and a value).

  --mode )";

constexpr char kHelpEnd[] = R"(   how the team comes about (exact)
  --seconds S   processor time of the search for each instance, one thread,
                CBC's part included (0.5); not wall-clock time

A line a set (a file's name up to its first dot): instances with a reference
above 0; share, the sum of values over the sum of references; mean of the
instances' shares; hits, references reached; above, references exceeded;
seconds of processor time; and values against the mode's own bound, where it
has one. Every plan is checked for lengths and points visited twice; a fault
ends the program. The last line is the share of all sets.
)";

struct ProgramArguments {
  std::string folder;
  std::string reference_file;
  TeamTourOptions options;
};

double ParseSeconds(const std::string& text) {
  double seconds = 0.0;
  const char* end = text.data() + text.size();
  const auto parsed = std::from_chars(text.data(), end, seconds);
  if (parsed.ec != std::errc() || parsed.ptr != end ||
      !(seconds >= 0.0 && std::isfinite(seconds))) {
    throw kg_base::InputError(
        "--seconds: expected a number not below 0, got '" + text + "'");
  }
  return seconds;
}

TourPlanner FindPlanner(const std::string& text) {
  const TeamMode* mode = FindTeamMode(text);
  if (mode == nullptr) {
    throw kg_base::InputError("--mode: expected " + TeamModeChoices() +
                              ", got '" + text + "'");
  }
  return mode->plan_tours;
}

// The names of all modes, parted by '|'.
std::string ModeNames() { return kg_base::JoinStrings(TeamModeNames(), "|"); }

ProgramArguments Parse(const std::vector<std::string>& words) {
  ProgramArguments arguments;
  std::vector<std::string> places;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool option = words[i].rfind("--", 0) == 0;
    if (!option) {
      places.push_back(words[i]);
      continue;
    }
    if (words[i] != "--mode" && words[i] != "--seconds") {
      throw kg_base::InputError(words[i] + ": no such option; see --help");
    }
    // Every option has a value.
    if (i + 1 == words.size()) {
      throw kg_base::InputError(words[i] + ": expected a value after it");
    }
    if (words[i] == "--mode") {
      arguments.options.planner = FindPlanner(words[i + 1]);
    } else {
      arguments.options.seconds = ParseSeconds(words[i + 1]);
    }
    ++i;
  }
  if (places.size() != 2) {
    throw kg_base::InputError("expected FOLDER and REFERENCE_FILE; see --help");
  }
  arguments.folder = places[0];
  arguments.reference_file = places[1];
  return arguments;
}

void Run(const std::vector<std::string>& words) {
  const ProgramArguments arguments = Parse(words);
  TopScore all;
  for (const auto& [set, score] :
       RunTop(arguments.folder, arguments.reference_file, arguments.options,
              &std::cout)) {
    all.Add(score);
  }
  if (all.instances == 0) {
    throw kg_base::InputError(arguments.reference_file +
                              ": no reference above 0 for any instance");
  }
  std::printf("share of reference %.2f %%\n", all.share());
}

}  // namespace
}  // namespace kg_selector

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  for (const std::string& word : words) {
    if (word == "--help" || word == "-h") {
      std::cout << kg_selector::kHelpBegin << kg_selector::ModeNames()
                << kg_selector::kHelpEnd;
      return 0;
    }
  }
  try {
    kg_selector::Run(words);
  } catch (const std::exception& error) {
    std::cout.flush();
    std::cerr << "team_orienteering: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
