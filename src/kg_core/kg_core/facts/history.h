// Past states of the facts. The log (update_log.h) records what every update
// removed and added, so any version of the facts can be restored by undoing the
// later updates.
//
//   FindDifferences(*store.Read(), 12, 15)   changes, with author and time
//   FindDifferences(*store.Read(), 0, 12)    all facts at world version 12

#ifndef KG_CORE_FACTS_HISTORY_H_
#define KG_CORE_FACTS_HISTORY_H_

#include <cstdint>
#include <string>
#include <vector>

#include "kg_core/rdf/graph_view.h"
#include "kg_core/rdf/store.h"

namespace kg_core {

// The values of one property of one subject that an update removed and added.
struct FactChange {
  Term subject;
  Term property;
  std::vector<Term> old_values;
  std::vector<Term> new_values;
};

struct LoggedUpdate {
  std::uint64_t world_version = 0;  // World version after the update.
  std::string time;                 // xsd:dateTime, UTC.
  std::string author;
  std::string id;  // Chosen by the sender, may be empty.
  std::vector<FactChange> changes;
};

// Every logged update, oldest first; changes by subject and property.
std::vector<LoggedUpdate> ReadLog(const GraphView& view);

// A statement in the facts of only one of two versions, and the last update
// between them that changed this property of this subject.
struct FactDifference {
  Statement statement;
  bool is_added = false;  // false: removed.
  std::uint64_t world_version = 0;
  std::string time;
  std::string author;
};

// The differences from version `before` to `after`, sorted; `after` may be the
// older one. Before version 1 there are no facts. Throws InputError for a
// version that does not exist yet.
std::vector<FactDifference> FindDifferences(const GraphView& view,
                                            std::uint64_t before,
                                            std::uint64_t after);

}  // namespace kg_core

#endif  // KG_CORE_FACTS_HISTORY_H_
