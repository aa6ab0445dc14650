// Continuous queries, whose answers are reported whenever they change.
//
//   WatchList watches;
//   watches.Watch({"agents", "SELECT ?a { ?a a ex:Agent }"}, *view, dataset);
//   ...
//   for (const std::string& id : watches.ids()) {
//     if (const auto news = watches.Look(id, *store.Read(), dataset)) ...
//   }
//
// An answer is a multiset of rows; their order is irrelevant. Added and removed
// rows are relative to the previous report, so a receiver that applies all
// reports has the current answer, even if intermediate states were skipped.

#ifndef KG_CORE_WATCH_WATCH_LIST_H_
#define KG_CORE_WATCH_WATCH_LIST_H_

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "kg_core/rdf/graph_view.h"
#include "kg_core/sparql/query_engine.h"

namespace kg_core {

struct WatchDefinition {
  std::string id;  // 1 to 64 letters, digits, '_' and '-'.
  std::string query;
};
bool operator==(const WatchDefinition& a, const WatchDefinition& b);

// Limits of a watch list. Those of its queries are far below the limits of a
// single query, because watches are evaluated repeatedly.
struct WatchLimits {
  std::size_t watches = 64;
  QueryLimits query{0.5, 10000, 4u << 20, 16u << 10, 200, 64u << 20};
};

using Rows = std::vector<std::vector<std::optional<Term>>>;

struct WatchedAnswer {
  std::string id;
  std::uint64_t world_version = 0;  // Version of the state that was read.
  // True for the first answer after Watch() or Keep().
  bool is_first = false;
  std::string error;  // Reason if the query failed; `answer` is
                      // then the previous one.
  QueryResult answer;
  Rows added;    // Rows added and removed since the previous
  Rows removed;  // report, sorted, with multiplicity.
};

// Not thread-safe.
class WatchList {
 public:
  explicit WatchList(WatchLimits limits = {}) : limits_(limits) {}

  // Adds a watch and returns its first answer. An empty id is replaced by a
  // free one. Repeating the same query and id changes nothing and returns the
  // last reported answer; a different query replaces the old one. Throws
  // InputError if the query is not a SELECT, the id is invalid, there are too
  // many watches, or there is no answer within the limits.
  WatchedAnswer Watch(WatchDefinition definition, const GraphView& view,
                      const Dataset& dataset);
  // Adds a watch without running the query: the next Look() gives the first
  // answer.
  void Keep(WatchDefinition definition);
  bool Cancel(const std::string& id);  // Returns false if unknown.

  // Evaluates watch `id`; nullopt if its answer is the same multiset of rows as
  // before. A failing query is reported once, stays in the list, and is
  // reported again when it has an answer.
  std::optional<WatchedAnswer> Look(const std::string& id,
                                    const GraphView& view,
                                    const Dataset& dataset);

  std::vector<std::string> ids() const;
  std::vector<WatchDefinition> definitions() const;

 private:
  struct State {
    std::string query;
    bool has_answer = false;
    QueryResult answer;
    Rows rows;  // Rows of the answer, sorted.
    std::string error;
    std::uint64_t world_version = 0;
  };

  std::string FreeId() const;
  WatchedAnswer Report(const std::string& id, const State& state) const;

  const WatchLimits limits_;
  std::map<std::string, State> states_;  // By id.
};

}  // namespace kg_core

#endif  // KG_CORE_WATCH_WATCH_LIST_H_
