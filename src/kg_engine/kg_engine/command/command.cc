#include "kg_engine/command/command.h"

#include <algorithm>
#include <iomanip>
#include <iostream>

namespace kg_engine::command {
namespace {

const std::vector<const Subcommand*>& Subcommands() {
  static const std::vector<const Subcommand*> subcommands = {
      &kQuery, &kUpdate,      &kValidate, &kExport, &kImport, &kDiff,
      &kLog,   &kConformance, &kServe,    &kWhy,    &kCheck,
  };
  return subcommands;
}

constexpr char kTargets[] =
    "TARGET is a store (a file, or a state folder with store.db in it), or a\n"
    "mission folder with mission.ttl in it, which is read into memory.\n";

void PrintOverview(std::ostream& out) {
  out << "usage: kg SUBCOMMAND ...\n\n";
  for (const Subcommand* subcommand : Subcommands()) {
    out << "  " << std::left << std::setw(13) << subcommand->name
        << subcommand->summary << "\n";
  }
  out << "\n" << kTargets << "`kg SUBCOMMAND --help` says more.\n";
}

void PrintHelp(const Subcommand& subcommand) {
  std::cout << "usage: kg " << subcommand.name << " " << subcommand.arguments
            << "\n\n"
            << subcommand.summary << ".\n\n"
            << subcommand.help;
}

const Subcommand* FindSubcommand(const std::string& name) {
  for (const Subcommand* subcommand : Subcommands()) {
    if (name == subcommand->name) return subcommand;
  }
  return nullptr;
}

// Prints an error as one line.
int Complain(const std::string& who, std::string what, int status) {
  std::replace(what.begin(), what.end(), '\n', ' ');
  std::cerr << who << ": " << what << std::endl;
  return status;
}

int Run(const Subcommand& subcommand, const std::vector<std::string>& line) {
  const std::string who = std::string("kg ") + subcommand.name;
  try {
    const int status = subcommand.run(ParseArguments(line, subcommand.options));
    if (std::cout.flush()) return status;
    return Complain(who, "the output cannot be written", kRefused);
  } catch (const UsageError& error) {
    return Complain(who, std::string(error.what()) + "; see " + who + " --help",
                    kMisused);
  } catch (const std::exception& error) {
    return Complain(who, error.what(), kRefused);
  }
}

bool AsksForHelp(const std::string& word) {
  return word == "--help" || word == "-h";
}

}  // namespace

std::optional<std::string> Arguments::One(const std::string& option) const {
  const std::vector<std::string> values = All(option);
  if (values.size() > 1) throw UsageError(option + " is given twice");
  return values.empty() ? std::nullopt : std::optional(values[0]);
}

std::vector<std::string> Arguments::All(const std::string& option) const {
  const auto found = options.find(option);
  return found == options.end() ? std::vector<std::string>() : found->second;
}

void Arguments::ExpectWords(std::size_t least, std::size_t most,
                            const std::string& expected) const {
  if (words.size() >= least && words.size() <= most) return;
  throw UsageError("expected " + expected + ", got " +
                   std::to_string(words.size()) +
                   (words.size() == 1 ? " argument" : " arguments"));
}

Arguments ParseArguments(const std::vector<std::string>& line,
                         const std::vector<Option>& options) {
  Arguments arguments;
  bool only_words = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const std::string& word = line[i];
    if (only_words || word.size() < 2 || word[0] != '-') {
      arguments.words.push_back(word);
      continue;
    }
    if (word == "--") {
      only_words = true;
      continue;
    }
    const auto option =
        std::find_if(options.begin(), options.end(),
                     [&](const Option& known) { return known.name == word; });
    if (option == options.end()) throw UsageError("unknown option " + word);
    if (option->has_value && i + 1 == line.size()) {
      throw UsageError(word + " lacks its value");
    }
    arguments.options[word].push_back(option->has_value ? line[++i] : "");
  }
  return arguments;
}

int RunCommand(const std::vector<std::string>& line) {
  if (line.empty()) {
    PrintOverview(std::cerr);
    return kMisused;
  }
  if (AsksForHelp(line[0])) {
    PrintOverview(std::cout);
    return kDone;
  }
  const Subcommand* subcommand = FindSubcommand(line[0]);
  if (subcommand == nullptr) {
    return Complain("kg", "unknown subcommand " + line[0] + "; see kg --help",
                    kMisused);
  }
  const std::vector<std::string> rest(line.begin() + 1, line.end());
  const auto end = std::find(rest.begin(), rest.end(), "--");
  if (std::any_of(rest.begin(), end, AsksForHelp)) {
    PrintHelp(*subcommand);
    return kDone;
  }
  return Run(*subcommand, rest);
}

}  // namespace kg_engine::command
