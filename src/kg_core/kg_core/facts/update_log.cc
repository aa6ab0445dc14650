#include "kg_core/facts/update_log.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "kg_base/common/sha256.h"
#include "kg_core/facts/fact_writer.h"
#include "kg_core/facts/terms.h"

namespace kg_core {
namespace {

struct PropertyChange {
  std::vector<Term> old_values;
  std::vector<Term> new_values;
};
// Changes by subject and property.
using PropertyChanges = std::map<std::pair<Term, Term>, PropertyChange>;

PropertyChanges CollectChanges(const Transaction& transaction) {
  PropertyChanges changes;
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

// The author is a name, not an IRI: letters, digits, '-' and '_' are kept,
// other bytes are percent-encoded.
Term MakeAuthorIri(const std::string& author) {
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

long long NextVersion(const Transaction& transaction) {
  return static_cast<long long>(transaction.view().world_version()) + 1;
}

// Writes the activity of the transaction that creates `version`. It has zero
// duration.
void WriteActivity(const Term& activity, const char* type, double time_s,
                   long long version, FactWriter* write) {
  write->Activity(activity, type, time_s, time_s)
      .Integer("worldVersion", version);
}

void WriteAuthor(const Term& activity, const std::string& name,
                 FactWriter* write) {
  const Term author = MakeAuthorIri(name);
  write->About(author).Add(RdfType(), Prov("Agent"));
  write->About(activity)
      .Add(Prov("wasAssociatedWith"), author)
      .Text("author", name);
}

void WriteFiles(const Term& activity, const std::vector<SourceFile>& files,
                FactWriter* write) {
  for (const SourceFile& file : files) {
    kg_base::Hasher name;
    name.Add(file.path);
    name.Add(file.sha256);
    const Term node = Ex("file/" + name.Hex());
    write->About(node, "SourceFile")
        .Text("path", file.path)
        .Text("sha256", file.sha256);
    write->About(activity).Used(node);
  }
}

void WriteChange(const Term& entry, const Term& activity,
                 const std::pair<Term, Term>& fact,
                 const PropertyChange& change, FactWriter* write) {
  write->About(entry, "FactChange")
      .Link("inUpdate", activity)
      .Link("ofSubject", fact.first)
      .Link("ofProperty", fact.second);
  for (const Term& value : change.old_values) write->Link("oldValue", value);
  for (const Term& value : change.new_values) write->Link("newValue", value);
}

}  // namespace

void LogUpdate(const FactUpdate& update, double time_s,
               Transaction& transaction) {
  const PropertyChanges changes = CollectChanges(transaction);
  if (changes.empty()) return;
  const long long version = NextVersion(transaction);
  const Term activity = Iri(kLogGraph + ("/v" + std::to_string(version)));
  FactWriter prov(Iri(kProvGraph));
  WriteActivity(activity, "UpdateFacts", time_s, version, &prov);
  WriteAuthor(activity, update.author, &prov);
  WriteFiles(activity, update.files, &prov);
  prov.About(activity).Text("updateId", update.id);
  prov.AddTo(transaction);
  FactWriter log(Iri(kLogGraph));
  int count = 0;
  for (const auto& [fact, change] : changes) {
    WriteChange(Iri(activity.text + "/" + std::to_string(count++)), activity,
                fact, change, &log);
  }
  log.AddTo(transaction);
}

void LogVocabulary(const std::vector<SourceFile>& files, double time_s,
                   Transaction& transaction) {
  if (files.empty()) return;
  const long long version = NextVersion(transaction);
  const Term activity =
      Iri(kLogGraph + ("/vocabulary/v" + std::to_string(version)));
  FactWriter prov(Iri(kProvGraph));
  WriteActivity(activity, "LoadVocabulary", time_s, version, &prov);
  WriteAuthor(activity, "kg", &prov);
  WriteFiles(activity, files, &prov);
  prov.AddTo(transaction);
}

}  // namespace kg_core
