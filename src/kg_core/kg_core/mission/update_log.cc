// The log entry of an accepted update: one ex:UpdateFacts activity
// <graph/log/v12> in the provenance graph, and in the log graph an
// ex:FactChange for every fact that came or went.

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "kg_core/base/date_time.h"
#include "kg_core/mission/fact_update.h"
#include "kg_core/mission/terms.h"

namespace kg_core {
namespace {

struct Change {
  std::vector<Term> old_values;
  std::vector<Term> new_values;
};
// By subject and property.
using Changes = std::map<std::pair<Term, Term>, Change>;

Changes ChangesOf(const Transaction& transaction) {
  Changes changes;
  for (Statement& statement : transaction.removed()) {
    if (statement.graph != Facts()) continue;
    changes[{statement.subject, statement.predicate}].old_values.push_back(
        std::move(statement.object));
  }
  for (Statement& statement : transaction.added()) {
    if (statement.graph != Facts()) continue;
    changes[{statement.subject, statement.predicate}].new_values.push_back(
        std::move(statement.object));
  }
  return changes;
}

// An author is a name, not an IRI: letters, digits, '-', '_' stay, other bytes
// become %XX.
Term AuthorIri(const std::string& author) {
  static constexpr char kHex[] = "0123456789ABCDEF";
  std::string local;
  for (const char letter : author.empty() ? "anonymous" : author) {
    const auto byte = static_cast<unsigned char>(letter);
    const bool is_plain =
        (byte >= '0' && byte <= '9') || (byte >= 'A' && byte <= 'Z') ||
        (byte >= 'a' && byte <= 'z') || byte == '-' || byte == '_';
    if (is_plain) {
      local += letter;
    } else {
      local += {'%', kHex[byte >> 4], kHex[byte & 15]};
    }
  }
  return Ex("author/" + local);
}

}  // namespace

void LogUpdate(const FactUpdate& update, double time_s,
               Transaction& transaction) {
  const Changes changes = ChangesOf(transaction);
  if (changes.empty()) return;
  const auto version =
      static_cast<long long>(transaction.view().world_version()) + 1;
  const Term activity = Iri(kLogGraph + ("/v" + std::to_string(version)));
  const Term author = AuthorIri(update.author);
  const Term time =
      Literal(FormatDateTime(time_s), std::string(kXsd) + "dateTime");
  const auto say = [&](const char* graph, const Term& subject, Term property,
                       Term object) {
    transaction.Add(
        {subject, std::move(property), std::move(object), Iri(graph)});
  };
  say(kProvGraph, activity, RdfType(), Ex("UpdateFacts"));
  say(kProvGraph, activity, RdfType(), Prov("Activity"));
  say(kProvGraph, activity, Prov("startedAtTime"), time);
  say(kProvGraph, activity, Prov("wasAssociatedWith"), author);
  say(kProvGraph, activity, Ex("worldVersion"), IntegerLiteral(version));
  say(kProvGraph, author, RdfType(), Prov("Agent"));
  say(kProvGraph, activity, Ex("author"), Literal(update.author));
  say(kProvGraph, activity, Ex("updateId"), Literal(update.id));
  int count = 0;
  for (const auto& [key, change] : changes) {
    const Term entry = Iri(activity.text + "/" + std::to_string(count++));
    say(kLogGraph, entry, RdfType(), Ex("FactChange"));
    say(kLogGraph, entry, Ex("inUpdate"), activity);
    say(kLogGraph, entry, Ex("ofSubject"), key.first);
    say(kLogGraph, entry, Ex("ofProperty"), key.second);
    for (const Term& value : change.old_values) {
      say(kLogGraph, entry, Ex("oldValue"), value);
    }
    for (const Term& value : change.new_values) {
      say(kLogGraph, entry, Ex("newValue"), value);
    }
  }
}

}  // namespace kg_core
