#include "kg_core/watch/watch_list.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "kg_base/common/input_error.h"
#include "kg_base/common/limit_error.h"
#include "kg_core/sparql/parser.h"

namespace kg_core {
namespace {

using kg_base::InputError;

constexpr std::size_t kMaxIdBytes = 64;

bool IsIdChar(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
         (c >= '0' && c <= '9') || c == '_' || c == '-';
}

void CheckId(const std::string& id) {
  if (!id.empty() && id.size() <= kMaxIdBytes &&
      std::all_of(id.begin(), id.end(), IsIdChar)) {
    return;
  }
  throw InputError("watch '" + id + "': expected an id of 1 to " +
                   std::to_string(kMaxIdBytes) +
                   " letters, digits, '_' and '-'");
}

void CheckIsSelect(const std::string& query, const QueryLimits& limits) {
  if (query.size() > limits.text_bytes) {
    throw kg_base::LimitError("the query is longer than the limit of " +
                              std::to_string(limits.text_bytes) + " bytes");
  }
  const sparql::Query parsed = sparql::ParseQuery(query, limits.nesting);
  if (parsed.form == sparql::Query::Form::kSelect) return;
  throw InputError("expected a SELECT: only rows are watched");
}

Rows Sorted(Rows rows) {
  std::sort(rows.begin(), rows.end());
  return rows;
}

// Multiset difference a - b: a row that is in a three times and in b once is
// left twice.
Rows Without(const Rows& a, const Rows& b) {
  Rows left;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(),
                      std::back_inserter(left));
  return left;
}

}  // namespace

bool operator==(const WatchDefinition& a, const WatchDefinition& b) {
  return a.id == b.id && a.query == b.query;
}

std::string WatchList::FreeId() const {
  for (std::size_t number = 1;; ++number) {
    std::string id = "watch" + std::to_string(number);
    if (states_.count(id) == 0) return id;
  }
}

WatchedAnswer WatchList::Report(const std::string& id,
                                const State& state) const {
  WatchedAnswer report;
  report.id = id;
  report.world_version = state.world_version;
  report.error = state.error;
  report.answer = state.answer;
  return report;
}

WatchedAnswer WatchList::Watch(WatchDefinition definition,
                               const GraphView& view, const Dataset& dataset) {
  if (definition.id.empty()) definition.id = FreeId();
  CheckId(definition.id);
  const auto known = states_.find(definition.id);
  const bool is_new = known == states_.end();
  // The same watch again: return the last answer without running the query.
  if (!is_new && known->second.query == definition.query &&
      known->second.has_answer) {
    return Report(definition.id, known->second);
  }
  if (is_new && states_.size() >= limits_.watches) {
    throw InputError("there are " + std::to_string(states_.size()) +
                     " watches, the limit; cancel one");
  }
  CheckIsSelect(definition.query, limits_.query);
  State state;
  state.query = std::move(definition.query);
  state.answer = RunQuery(view, state.query, dataset, limits_.query);
  state.has_answer = true;
  state.rows = Sorted(state.answer.rows);
  state.world_version = view.world_version();
  WatchedAnswer first = Report(definition.id, state);
  first.is_first = true;
  first.added = state.rows;
  states_[definition.id] = std::move(state);
  return first;
}

void WatchList::Keep(WatchDefinition definition) {
  CheckId(definition.id);
  State state;
  state.query = std::move(definition.query);
  states_[definition.id] = std::move(state);
}

bool WatchList::Cancel(const std::string& id) { return states_.erase(id) > 0; }

std::optional<WatchedAnswer> WatchList::Look(const std::string& id,
                                             const GraphView& view,
                                             const Dataset& dataset) {
  const auto found = states_.find(id);
  if (found == states_.end()) return std::nullopt;
  State& state = found->second;
  QueryResult answer;
  std::string error;
  try {
    answer = RunQuery(view, state.query, dataset, limits_.query);
  } catch (const InputError& failure) {
    error = failure.what();
  }
  const bool failed_before = !state.error.empty();
  state.world_version = view.world_version();
  state.error = error;
  // A failure is reported once, until the query succeeds again.
  if (!error.empty()) {
    if (failed_before) return std::nullopt;
    return Report(id, state);
  }
  Rows rows = Sorted(answer.rows);
  if (state.has_answer && !failed_before && rows == state.rows) {
    return std::nullopt;
  }
  state.answer = std::move(answer);
  WatchedAnswer report = Report(id, state);
  report.is_first = !state.has_answer;
  report.added = Without(rows, state.rows);
  report.removed = Without(state.rows, rows);
  state.rows = std::move(rows);
  state.has_answer = true;
  return report;
}

std::vector<std::string> WatchList::ids() const {
  std::vector<std::string> ids;
  for (const auto& [id, state] : states_) ids.push_back(id);
  return ids;
}

std::vector<WatchDefinition> WatchList::definitions() const {
  std::vector<WatchDefinition> definitions;
  for (const auto& [id, state] : states_) {
    definitions.push_back({id, state.query});
  }
  return definitions;
}

}  // namespace kg_core
