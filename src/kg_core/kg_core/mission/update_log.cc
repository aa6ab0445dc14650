// The log entry of an accepted update: one ex:UpdateFacts activity
// <graph/log/v12> in the provenance graph, and in the log graph an
// ex:FactChange for every fact that came or went. Files that facts or
// vocabulary came from are nodes of their own, one for each path and content.

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "kg_core/base/date_time.h"
#include "kg_core/base/sha256.h"
#include "kg_core/facts/terms.h"
#include "kg_core/mission/stage_update.h"

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

// Adds statements to the graphs of provenance and log.
class Log {
 public:
  explicit Log(Transaction& transaction)
      : transaction_(transaction),
        version_(static_cast<long long>(transaction.view().world_version()) +
                 1) {}

  long long version() const { return version_; }

  void Say(const char* graph, const Term& subject, Term property, Term object) {
    transaction_.Add(
        {subject, std::move(property), std::move(object), Iri(graph)});
  }
  void Prove(const Term& subject, Term property, Term object) {
    Say(kProvGraph, subject, std::move(property), std::move(object));
  }

  // An activity of this transaction: it takes no time that anybody could see.
  void Activity(const Term& activity, const char* type, double time_s) {
    const Term time =
        Literal(FormatDateTime(time_s), std::string(kXsd) + "dateTime");
    Prove(activity, RdfType(), Ex(type));
    Prove(activity, RdfType(), Prov("Activity"));
    Prove(activity, Prov("startedAtTime"), time);
    Prove(activity, Prov("endedAtTime"), time);
    Prove(activity, Ex("worldVersion"), IntegerLiteral(version_));
  }

  void Author(const Term& activity, const std::string& name) {
    const Term author = AuthorIri(name);
    Prove(author, RdfType(), Prov("Agent"));
    Prove(activity, Prov("wasAssociatedWith"), author);
    Prove(activity, Ex("author"), Literal(name));
  }

  void Used(const Term& activity, const std::vector<SourceFile>& files) {
    for (const SourceFile& file : files) {
      Hasher name;
      name.Add(file.path);
      name.Add(file.sha256);
      const Term node = Ex("file/" + name.Hex());
      Prove(node, RdfType(), Ex("SourceFile"));
      Prove(node, Ex("path"), Literal(file.path));
      Prove(node, Ex("sha256"), Literal(file.sha256));
      Prove(activity, Prov("used"), node);
    }
  }

  void Changed(const Term& entry, const Term& activity,
               const std::pair<Term, Term>& fact, const Change& change) {
    Say(kLogGraph, entry, RdfType(), Ex("FactChange"));
    Say(kLogGraph, entry, Ex("inUpdate"), activity);
    Say(kLogGraph, entry, Ex("ofSubject"), fact.first);
    Say(kLogGraph, entry, Ex("ofProperty"), fact.second);
    for (const Term& value : change.old_values) {
      Say(kLogGraph, entry, Ex("oldValue"), value);
    }
    for (const Term& value : change.new_values) {
      Say(kLogGraph, entry, Ex("newValue"), value);
    }
  }

 private:
  Transaction& transaction_;
  const long long version_;
};

}  // namespace

void LogUpdate(const FactUpdate& update, double time_s,
               Transaction& transaction) {
  const Changes changes = ChangesOf(transaction);
  if (changes.empty()) return;
  Log log(transaction);
  const Term activity = Iri(kLogGraph + ("/v" + std::to_string(log.version())));
  log.Activity(activity, "UpdateFacts", time_s);
  log.Author(activity, update.author);
  log.Used(activity, update.files);
  log.Prove(activity, Ex("updateId"), Literal(update.id));
  int count = 0;
  for (const auto& [fact, change] : changes) {
    log.Changed(Iri(activity.text + "/" + std::to_string(count++)), activity,
                fact, change);
  }
}

void LogVocabulary(const std::vector<SourceFile>& files, double time_s,
                   Transaction& transaction) {
  if (files.empty()) return;
  Log log(transaction);
  const Term activity =
      Iri(kLogGraph + ("/vocabulary/v" + std::to_string(log.version())));
  log.Activity(activity, "LoadVocabulary", time_s);
  log.Author(activity, "kg");
  log.Used(activity, files);
}

}  // namespace kg_core
