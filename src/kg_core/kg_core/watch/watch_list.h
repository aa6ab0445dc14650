// Queries whose answers are reported whenever they change.
//
//   WatchList watches;
//   watches.Watch({"agents", "SELECT ?a { ?a a ex:Agent }"}, *view, dataset);
//   ...
//   for (const std::string& id : watches.ids()) {
//     if (const auto news = watches.Look(id, *store.Read(), dataset)) ...
//   }
//
// An answer is a bag of rows: their order does not count. What was added and
// removed is counted from the answer reported before, so that whoever adds and
// takes away holds the answer, whatever states nobody looked at lay between.

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

// Far below those of a single query: watches are run again and again.
struct WatchLimits {
  std::size_t watches = 64;
  QueryLimits query{0.5, 10000, 4u << 20, 16u << 10, 200, 64u << 20};
};

using Rows = std::vector<std::vector<std::optional<Term>>>;

struct WatchedAnswer {
  std::string id;
  std::uint64_t world_version = 0;  // Of the state that was read.
  // There was none before: after Watch() or Keep().
  bool is_first = false;
  std::string error;  // Why the query ended without an answer;
                      // then `answer` is the one before.
  QueryResult answer;
  Rows added;    // Since the answer reported before, sorted, as often as they
  Rows removed;  // came or went.
};

// Not for several threads at once.
class WatchList {
 public:
  explicit WatchList(WatchLimits limits = {}) : limits_(limits) {}

  // Begins to watch, and its first answer. An empty id is replaced by one that
  // is free. The same query under the same id again changes nothing and gives
  // the answer reported last; another query takes its place. Throws InputError:
  // not a SELECT, an id that is none, too many watches, no answer within the
  // limits.
  WatchedAnswer Watch(WatchDefinition definition, const GraphView& view,
                      const Dataset& dataset);
  // Begins to watch without an answer: the next Look() is the first.
  void Keep(WatchDefinition definition);
  bool Cancel(const std::string& id);  // Was there one?

  // What to report of `id` now: nothing if its answer is the same bag of rows
  // as before. A query that fails is reported once, stays, and is reported when
  // it has an answer again.
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
    Rows rows;  // Of the answer, sorted.
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
