// kg update TARGET ...

#include <cstdlib>

#include "kg_base/common/input_error.h"
#include "kg_base/common/text.h"
#include "kg_core/rdf/syntax.h"
#include "kg_engine/command/change.h"
#include "kg_engine/command/command.h"
#include "kg_engine/command/target.h"

namespace kg_engine::command {
namespace {

using kg_core::Fact;
using kg_core::FactUpdate;

constexpr std::size_t kMaxUpdateBytes = 64u << 20;

// Parses "set", "add" and "remove" with their facts.
void ReadFact(const std::vector<std::string>& words, FactUpdate* update) {
  const std::string& what = words[1];
  const auto word = [&](std::size_t i) {
    return i < words.size() ? words[i] : std::string();
  };
  const Fact fact = {word(2), word(3), word(4)};
  const bool is_whole = words.size() == 5;
  if (what == "remove" && words.size() >= 3 && words.size() <= 5) {
    update->remove.push_back(fact);
  } else if (what == "set" && is_whole) {
    update->set.push_back(fact);
  } else if (what == "add" && is_whole) {
    update->add.push_back(fact);
  } else {
    throw UsageError("expected " + what + " SUBJECT PROPERTY VALUE");
  }
}

void ReadUpdateFile(const std::string& file, FactUpdate* update) {
  const std::string text = kg_base::ReadFile(file, kMaxUpdateBytes);
  const auto* syntax = kg_core::SyntaxOfPath(file);
  const bool is_turtle =
      syntax != nullptr && syntax->syntax == kg_core::RdfSyntax::kTurtle;
  if (syntax != nullptr && !is_turtle) {
    throw UsageError(file + ": expected SPARQL Update (.ru) or Turtle (.ttl)");
  }
  (is_turtle ? update->turtle : update->sparql) = text;
}

FactUpdate ReadUpdate(const Arguments& arguments) {
  const std::vector<std::string>& words = arguments.words;
  FactUpdate update;
  const char* user = std::getenv("USER");
  update.author =
      arguments.One("--author").value_or(user == nullptr ? "" : user);
  const auto text = arguments.One("-e");
  if (text.has_value() == (words.size() > 1)) {
    throw UsageError("expected one of -e, a file, set, add or remove");
  }
  if (text) {
    update.sparql = *text;
  } else if (words[1] == "set" || words[1] == "add" || words[1] == "remove") {
    ReadFact(words, &update);
  } else {
    arguments.ExpectWords(2, 2, "TARGET and one file");
    ReadUpdateFile(words[1], &update);
  }
  return update;
}

int RunUpdate(const Arguments& arguments) {
  arguments.ExpectWords(1, 5, "TARGET and an update");
  const FactUpdate update = ReadUpdate(arguments);
  const std::string data = arguments.One("--data").value_or("");
  if (IsMissionFolder(arguments.words[0]) && !arguments.Has("--check")) {
    throw kg_base::InputError(
        arguments.words[0] +
        ": a mission folder is not changed; edit its mission.ttl, or give "
        "--check to see whether the update would be accepted");
  }
  const Target target = OpenTarget(arguments.words[0], data);
  kg_core::Transaction transaction = target.store->Begin();
  const auto reasons = Stage(update, data, target, &transaction);
  if (!arguments.Has("--check") || !reasons.empty()) {
    return Finish(reasons, &transaction);
  }
  return kDone;
}

}  // namespace

const Subcommand kUpdate = {
    "update",
    "TARGET [--author NAME] [--check] (FILE | -e TEXT | set S P V | add S P V "
    "| remove S [P [V]])",
    "change facts: one transaction, checked, logged, or refused whole",
    "FILE is SPARQL 1.1 Update, or Turtle to be added if it ends in .ttl. "
    "TEXT\n"
    "is SPARQL 1.1 Update. S, P and V are terms of Turtle with our prefixes;\n"
    "`set` replaces all values, `remove` without V takes all values.\n"
    "Reasons to refuse it go to standard error, a line each.\n\n"
    "  --author NAME  who asks, kept in the log; otherwise $USER\n"
    "  --check        only say whether it would be accepted\n"
    "  --data FOLDER  where a mission's files are looked up first\n",
    {{"--author", true}, {"--check"}, {"-e", true}, {"--data", true}},
    RunUpdate};

}  // namespace kg_engine::command
