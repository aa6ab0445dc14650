// kg diff STORE VERSION VERSION, kg log STORE

#include <charconv>
#include <iostream>

#include "kg_core/facts/history.h"
#include "kg_core/rdf/turtle.h"
#include "kg_engine/command/command.h"
#include "kg_engine/command/target.h"

namespace kg_engine::command {
namespace {

using kg_core::FactChange;
using kg_core::FactDifference;
using kg_core::LoggedUpdate;
using kg_core::Term;

std::uint64_t Version(const std::string& text) {
  std::uint64_t version = 0;
  const char* end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, version);
  if (read.ec == std::errc() && read.ptr == end && !text.empty()) {
    return version;
  }
  throw UsageError("expected a world version, not " + text);
}

// Escapes names so that each entry stays on one line.
std::string Shown(const std::string& name) {
  std::string shown;
  for (const char c : name) {
    shown += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return shown.empty() ? "anonymous" : shown;
}

int RunDiff(const Arguments& arguments) {
  arguments.ExpectWords(3, 3, "STORE VERSION VERSION");
  const std::uint64_t before = Version(arguments.words[1]);
  const std::uint64_t after = Version(arguments.words[2]);
  const Target target = OpenStore(arguments.words[0]);
  for (const FactDifference& difference :
       kg_core::FindDifferences(*target.store->Read(), before, after)) {
    const kg_core::Statement& s = difference.statement;
    std::cout << (difference.is_added ? "+ " : "- ") << s.subject << " "
              << s.predicate << " " << s.object << " .  # version "
              << difference.world_version << ", " << difference.time << ", "
              << Shown(difference.author) << "\n";
  }
  return kDone;
}

void ShowChange(const FactChange& change) {
  for (const Term& value : change.old_values) {
    std::cout << "  - " << change.subject << " " << change.property << " "
              << value << "\n";
  }
  for (const Term& value : change.new_values) {
    std::cout << "  + " << change.subject << " " << change.property << " "
              << value << "\n";
  }
}

void ShowUpdate(const LoggedUpdate& update,
                const std::optional<Term>& subject) {
  bool is_shown = false;
  for (const FactChange& change : update.changes) {
    if (subject && change.subject != *subject) continue;
    if (!is_shown) {
      std::cout << "version " << update.world_version << ", " << update.time
                << ", " << Shown(update.author)
                << (update.id.empty() ? "" : " (" + Shown(update.id) + ")")
                << "\n";
    }
    is_shown = true;
    ShowChange(change);
  }
}

int RunLog(const Arguments& arguments) {
  arguments.ExpectWords(1, 1, "one STORE");
  std::optional<Term> subject;
  if (const auto text = arguments.One("--subject")) {
    subject = kg_core::ParseTurtleTerm(*text);
  }
  const Target target = OpenStore(arguments.words[0]);
  const auto log = kg_core::ReadLog(*target.store->Read());
  for (auto update = log.rbegin(); update != log.rend(); ++update) {
    ShowUpdate(*update, subject);
  }
  return kDone;
}

}  // namespace

const Subcommand kDiff = {
    "diff",
    "STORE VERSION VERSION",
    "compare the facts of two world versions",
    "A line for each fact that only one of them has: - of the first, + of the\n"
    "second, and behind # the update that did it, when, and who asked for it.\n"
    "`kg log` lists the versions; version 0 has no facts.\n",
    {},
    RunDiff};

const Subcommand kLog = {
    "log",
    "STORE [--subject TERM]",
    "list the updates, newest first: who, when, old and new values",
    "  --subject TERM  only what was changed about it, e.g. ex:alpha\n",
    {{"--subject", true}},
    RunLog};

}  // namespace kg_engine::command
