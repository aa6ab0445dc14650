#include <algorithm>
#include <numeric>
#include <set>

#include "kg_selector/packing/packing.h"

namespace kg_selector {
namespace {

// A partial choice with its use of rows and agents.
class PackingStart {
 public:
  explicit PackingStart(const Packing& packing)
      : packing_(packing),
        rows_(packing.row_capacities.size()),
        agents_(packing.agent_counts.size()),
        conflicts_(packing.columns.size()),
        by_score_(packing.columns.size()) {
    for (const auto& [a, b] : packing.conflicts) {
      conflicts_[a].push_back(b);
      conflicts_[b].push_back(a);
    }
    std::iota(by_score_.begin(), by_score_.end(), 0);
    std::stable_sort(by_score_.begin(), by_score_.end(),
                     [&](int a, int b) { return Score(a) > Score(b); });
  }

  void Add(int column) {
    chosen_.insert(column);
    agents_[packing_.columns[column].agent].insert(column);
    for (int row : packing_.columns[column].rows) rows_[row].insert(column);
  }

  void Fill() {
    for (int column : by_score_) {
      if (Score(column) <= 0.0) break;
      if (chosen_.count(column) > 0 || !IsOpen(column)) continue;
      const std::set<int> blockers = FindBlockers(column);
      if (blockers.empty()) Add(column);
    }
  }

  // Replaces blocking columns by one column where that improves the score.
  bool ExchangeOnce() {
    for (int column : by_score_) {
      if (chosen_.count(column) > 0 || !IsOpen(column)) continue;
      const std::set<int> blockers = FindBlockers(column);
      double lost = 0.0;
      for (int blocker : blockers) lost += Score(blocker);
      if (!(Score(column) > lost + 1e-12)) continue;
      for (int blocker : blockers) Remove(blocker);
      Add(column);
      return true;
    }
    return false;
  }

  std::vector<int> chosen() const { return {chosen_.begin(), chosen_.end()}; }

 private:
  double Score(int column) const { return packing_.columns[column].score; }

  // Whether the column is feasible on its own.
  bool IsOpen(int column) const {
    const Column& c = packing_.columns[column];
    return packing_.agent_counts[c.agent] > 0 &&
           std::all_of(c.rows.begin(), c.rows.end(), [&](int row) {
             return packing_.row_capacities[row] > 0;
           });
  }

  void Remove(int column) {
    chosen_.erase(column);
    agents_[packing_.columns[column].agent].erase(column);
    for (int row : packing_.columns[column].rows) rows_[row].erase(column);
  }

  // Columns to remove: from each full row or agent the one with the lowest
  // score.
  std::set<int> FindBlockers(int column) const {
    std::set<int> blockers;
    for (int other : conflicts_[column]) {
      if (chosen_.count(other) > 0) blockers.insert(other);
    }
    const Column& c = packing_.columns[column];
    AddBlocker(agents_[c.agent], packing_.agent_counts[c.agent], &blockers);
    for (int row : c.rows) {
      AddBlocker(rows_[row], packing_.row_capacities[row], &blockers);
    }
    return blockers;
  }

  void AddBlocker(const std::set<int>& users, int capacity,
                  std::set<int>* blockers) const {
    if (static_cast<int>(users.size()) < capacity) return;
    int min_value = -1;
    for (int user : users) {
      if (blockers->count(user) > 0) return;
      if (min_value < 0 || Score(user) < Score(min_value)) min_value = user;
    }
    if (min_value >= 0) blockers->insert(min_value);
  }

  const Packing& packing_;
  std::vector<std::set<int>> rows_;    // Columns that use each row.
  std::vector<std::set<int>> agents_;  // Chosen columns of each agent.
  std::vector<std::vector<int>> conflicts_;
  std::vector<int> by_score_;
  std::set<int> chosen_;
};

}  // namespace

std::vector<int> PackQuickly(const Packing& packing,
                             const std::vector<int>& start) {
  PackingStart choice(packing);
  for (int column : start) choice.Add(column);
  choice.Fill();
  while (choice.ExchangeOnce()) choice.Fill();
  return choice.chosen();
}

}  // namespace kg_selector
