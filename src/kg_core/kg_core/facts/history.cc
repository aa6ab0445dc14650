#include "kg_core/facts/history.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "kg_base/common/input_error.h"
#include "kg_core/facts/terms.h"

namespace kg_core {
namespace {

using kg_base::InputError;

// A fact without its graph, with ordering.
using Fact3 = std::tuple<Term, Term, Term>;
using Facts3 = std::set<Fact3>;

std::string GetText(const GraphView& view, const Term& subject,
                    const Term& property) {
  const auto value = FirstObject(view, kProvGraph, subject, property);
  return value ? value->text : std::string();
}

// Reads the update described by an ex:UpdateFacts activity, without its
// changes.
LoggedUpdate ReadActivity(const GraphView& view, const Term& activity) {
  LoggedUpdate update;
  const auto version =
      FirstObject(view, kProvGraph, activity, Ex("worldVersion"));
  const auto number = version ? NumericValue(*version) : std::nullopt;
  if (!number || !(*number >= 0)) {
    throw InputError("the log: " + ToTurtle(activity) +
                     " has no ex:worldVersion");
  }
  update.world_version = static_cast<std::uint64_t>(*number);
  update.time = GetText(view, activity, Prov("startedAtTime"));
  update.author = GetText(view, activity, Ex("author"));
  update.id = GetText(view, activity, Ex("updateId"));
  return update;
}

FactChange ReadChange(const GraphView& view, const Term& entry) {
  const auto subject = FirstObject(view, kLogGraph, entry, Ex("ofSubject"));
  const auto property = FirstObject(view, kLogGraph, entry, Ex("ofProperty"));
  if (!subject || !property) {
    throw InputError("the log: " + ToTurtle(entry) +
                     " has no subject or no property");
  }
  return {*subject, *property, Objects(view, kLogGraph, entry, Ex("oldValue")),
          Objects(view, kLogGraph, entry, Ex("newValue"))};
}

bool IsEarlier(const FactChange& a, const FactChange& b) {
  return std::tie(a.subject, a.property) < std::tie(b.subject, b.property);
}

Facts3 CurrentFacts(const GraphView& view) {
  Facts3 facts;
  Quad pattern;
  pattern.graph = view.Find(Facts());
  if (pattern.graph == kNoTerm) return facts;
  view.Match(pattern, [&](const Quad& quad) {
    facts.emplace(view.Get(quad.subject), view.Get(quad.predicate),
                  view.Get(quad.object));
    return true;
  });
  return facts;
}

void Undo(const LoggedUpdate& update, Facts3* facts) {
  for (const FactChange& change : update.changes) {
    for (const Term& value : change.new_values) {
      facts->erase({change.subject, change.property, value});
    }
    for (const Term& value : change.old_values) {
      facts->emplace(change.subject, change.property, value);
    }
  }
}

Facts3 Rewind(const GraphView& view, const std::vector<LoggedUpdate>& log,
              std::uint64_t world_version) {
  if (world_version > view.world_version()) {
    throw InputError("world version " + std::to_string(world_version) +
                     " does not exist yet; expected at most " +
                     std::to_string(view.world_version()));
  }
  Facts3 facts = CurrentFacts(view);
  for (auto update = log.rbegin(); update != log.rend(); ++update) {
    if (update->world_version > world_version) Undo(*update, &facts);
  }
  return facts;
}

Statement MakeStatement(const Fact3& fact) {
  return {std::get<0>(fact), std::get<1>(fact), std::get<2>(fact), Facts()};
}

// For each subject and property, the last update in (from, to].
using LastUpdates = std::map<std::pair<Term, Term>, const LoggedUpdate*>;

LastUpdates FindLastUpdates(const std::vector<LoggedUpdate>& log,
                            std::uint64_t from, std::uint64_t to) {
  LastUpdates last_updates;
  for (const LoggedUpdate& update : log) {
    if (update.world_version <= from || update.world_version > to) continue;
    for (const FactChange& change : update.changes) {
      last_updates[{change.subject, change.property}] = &update;
    }
  }
  return last_updates;
}

}  // namespace

std::vector<LoggedUpdate> ReadLog(const GraphView& view) {
  std::map<Term, LoggedUpdate> updates;
  Quad pattern;
  pattern.predicate = view.Find(Ex("inUpdate"));
  pattern.graph = view.Find(Iri(kLogGraph));
  if (pattern.predicate == kNoTerm || pattern.graph == kNoTerm) return {};
  view.Match(pattern, [&](const Quad& quad) {
    const Term& activity = view.Get(quad.object);
    auto found = updates.find(activity);
    if (found == updates.end()) {
      found = updates.emplace(activity, ReadActivity(view, activity)).first;
    }
    found->second.changes.push_back(ReadChange(view, view.Get(quad.subject)));
    return true;
  });
  // Sort updates by world version, and the changes of each by subject and
  // property.
  std::vector<LoggedUpdate> log;
  for (auto& [activity, update] : updates) {
    std::sort(update.changes.begin(), update.changes.end(), IsEarlier);
    log.push_back(std::move(update));
  }
  std::sort(log.begin(), log.end(), [](const auto& a, const auto& b) {
    return a.world_version < b.world_version;
  });
  return log;
}

std::vector<FactDifference> FindDifferences(const GraphView& view,
                                            std::uint64_t before,
                                            std::uint64_t after) {
  const std::vector<LoggedUpdate> log = ReadLog(view);
  const Facts3 old_facts = Rewind(view, log, before);
  const Facts3 new_facts = Rewind(view, log, after);
  const LastUpdates last_updates =
      FindLastUpdates(log, std::min(before, after), std::max(before, after));
  std::map<Fact3, bool> differing;  // True: added, false: removed.
  for (const Fact3& fact : old_facts) {
    if (new_facts.count(fact) == 0) differing[fact] = false;
  }
  for (const Fact3& fact : new_facts) {
    if (old_facts.count(fact) == 0) differing[fact] = true;
  }
  std::vector<FactDifference> differences;
  for (const auto& [fact, is_added] : differing) {
    const LoggedUpdate& update =
        *last_updates.at({std::get<0>(fact), std::get<1>(fact)});
    differences.push_back({MakeStatement(fact), is_added, update.world_version,
                           update.time, update.author});
  }
  return differences;
}

}  // namespace kg_core
