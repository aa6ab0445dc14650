#include "kg_selector/team/team_columns.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace kg_selector {
namespace {

constexpr double kRounding = 1e-9;

bool Exceeds(double a, double b) {
  return a - b > kRounding * std::max({1.0, std::abs(a), std::abs(b)});
}

}  // namespace

bool IsMore(const TeamWorth& a, const TeamWorth& b) {
  if (Exceeds(a.first, b.first)) return true;
  return !Exceeds(b.first, a.first) && Exceeds(a.second, b.second);
}

int TeamColumns::AddRow(int capacity) {
  capacities_.push_back(capacity);
  return static_cast<int>(capacities_.size()) - 1;
}

int TeamColumns::Add(Column column) {
  const int index = static_cast<int>(columns_.size());
  of_agent_[column.agent].push_back(index);
  unserved_ = std::min(unserved_, column.score);
  columns_.push_back(std::move(column));
  return index;
}

int TeamColumns::AddIfNew(Column column) {
  const int next = static_cast<int>(columns_.size());
  const auto known =
      by_rows_.emplace(std::pair(column.agent, column.rows), next);
  return known.second ? Add(std::move(column)) : known.first->second;
}

void TeamColumns::SetRows(int column, std::vector<int> rows) {
  columns_[column].rows = std::move(rows);
}

void TeamColumns::Drop(int agent) { of_agent_[agent].clear(); }

double TeamColumns::Reduced(int column,
                            const std::vector<double>& prices) const {
  double value = columns_[column].score;
  for (const int row : columns_[column].rows) {
    if (row < static_cast<int>(prices.size())) value -= prices[row];
  }
  return value;
}

double TeamColumns::Score(const TeamChoice& choice) const {
  double sum = 0.0;
  for (std::size_t a = 0; a < choice.size(); ++a) {
    if (choice[a] == kNobody) continue;
    sum += columns_[choice[a]].score;
    for (std::size_t b = 0; penalty && b < a; ++b) {
      if (choice[b] != kNobody) sum -= penalty(choice[b], choice[a]);
    }
  }
  return sum;
}

double TeamColumns::FairnessLoad(int column) const {
  if (fairness == Fairness::kMaxMin) return columns_[column].score - unserved_;
  return columns_[column].load;
}

TeamWorth TeamColumns::Worth(const TeamChoice& choice) const {
  TeamWorth worth{0.0, Score(choice)};
  double min_value = std::numeric_limits<double>::infinity();
  double max_value = 0.0;
  for (std::size_t a = 0; a < choice.size(); ++a) {
    // Agents without any offer do not count.
    if (of_agent_[a].empty()) continue;
    const bool served = choice[a] != kNobody;
    if (!served) worth.second += unserved_;
    const double load = served ? FairnessLoad(choice[a]) : 0.0;
    min_value = std::min(min_value, load);
    max_value = std::max(max_value, load);
  }
  if (fairness == Fairness::kNone || !std::isfinite(min_value)) return worth;
  if (fairness == Fairness::kMaxMin) {
    worth.first = min_value;
  } else {
    worth.second -= fairness_weight * (max_value - min_value);
  }
  return worth;
}

bool TeamColumns::IsAllowed(const TeamChoice& choice) const {
  std::vector<int> used(capacities_.size(), 0);
  for (std::size_t a = 0; a < choice.size(); ++a) {
    if (choice[a] == kNobody) continue;
    for (const int row : columns_[choice[a]].rows) {
      if (++used[row] > capacities_[row]) return false;
    }
    for (std::size_t b = 0; conflict && b < a; ++b) {
      if (choice[b] != kNobody && conflict(choice[b], choice[a])) return false;
    }
  }
  return true;
}

namespace {

// A mutable choice with the users of each row.
class ChoiceTable {
 public:
  ChoiceTable(const TeamColumns& pool, const TeamChoice& choice)
      : pool_(pool),
        choice_(pool.agents(), kNobody),
        users_(pool.capacities().size()) {
    for (const int column : choice) {
      if (column != kNobody) Put(column);
    }
  }

  const TeamChoice& choice() const { return choice_; }

  bool Fits(int column) const {
    for (const int row : pool_.columns()[column].rows) {
      if (IsFull(row)) return false;
    }
    for (const int other : choice_) {
      if (other != kNobody && pool_.Conflict(other, column)) return false;
    }
    return true;
  }

  void Put(int column) {
    choice_[pool_.columns()[column].agent] = column;
    for (const int row : pool_.columns()[column].rows) {
      users_[row].push_back(column);
    }
  }

  void Remove(int agent) {
    const int column = std::exchange(choice_[agent], kNobody);
    if (column == kNobody) return;
    for (const int row : pool_.columns()[column].rows) {
      users_[row].erase(
          std::find(users_[row].begin(), users_[row].end(), column));
    }
  }

  // Adds the column and removes blocking agents into `displaced`. False if it
  // fits into no plan.
  bool Displace(int column, std::vector<int>* displaced) {
    for (const int row : pool_.columns()[column].rows) {
      if (pool_.capacities()[row] < 1) return false;
      while (IsFull(row)) RemoveInto(FindWorst(users_[row]), displaced);
    }
    for (const int other : TeamChoice(choice_)) {
      if (other != kNobody && pool_.Conflict(other, column)) {
        RemoveInto(other, displaced);
      }
    }
    Put(column);
    return true;
  }

  // Best feasible column of an agent, penalties included.
  int BestFitting(int agent, const std::vector<int>& columns) const {
    int best = kNobody;
    double max_value = -std::numeric_limits<double>::infinity();
    for (const int column : columns) {
      if (!(pool_.columns()[column].score > max_value)) continue;
      const double value = pool_.columns()[column].score - TotalPenalty(column);
      if (value > max_value && Fits(column)) {
        max_value = value;
        best = column;
      }
    }
    return pool_.columns_of(agent).empty() ? kNobody : best;
  }

 private:
  bool IsFull(int row) const {
    return static_cast<int>(users_[row].size()) >= pool_.capacities()[row];
  }
  int FindWorst(const std::vector<int>& users) const {
    return *std::min_element(users.begin(), users.end(), [&](int a, int b) {
      const double x = pool_.columns()[a].score;
      const double y = pool_.columns()[b].score;
      return x != y ? x < y : a < b;
    });
  }
  void RemoveInto(int column, std::vector<int>* displaced) {
    displaced->push_back(pool_.columns()[column].agent);
    Remove(displaced->back());
  }
  double TotalPenalty(int column) const {
    double sum = 0.0;
    for (const int other : choice_) {
      if (pool_.penalty && other != kNobody) {
        sum += pool_.Penalty(other, column);
      }
    }
    return sum;
  }

  const TeamColumns& pool_;
  TeamChoice choice_;
  std::vector<std::vector<int>> users_;  // Chosen columns that use each row.
};

// Best columns of every agent under prices, best first.
std::vector<std::vector<int>> Shortlists(const TeamColumns& pool,
                                         const std::vector<double>& prices,
                                         std::size_t length) {
  std::vector<std::vector<int>> lists;
  // Computed once: sorting reads them often.
  std::vector<double> reduced;
  for (std::size_t c = 0; c < pool.columns().size(); ++c) {
    reduced.push_back(pool.Reduced(static_cast<int>(c), prices));
  }
  const auto better = [&](int a, int b) {
    return reduced[a] != reduced[b] ? reduced[a] > reduced[b] : a < b;
  };
  for (int agent = 0; agent < pool.agents(); ++agent) {
    std::vector<int> list = pool.columns_of(agent);
    const std::size_t kept = std::min(length, list.size());
    std::partial_sort(list.begin(), list.begin() + kept, list.end(), better);
    list.resize(kept);
    lists.push_back(std::move(list));
  }
  return lists;
}

class ColumnExchanger {
 public:
  ColumnExchanger(const TeamColumns& pool, const std::vector<double>& prices,
                  const TeamChoice& choice, const ExchangeOptions& options)
      : pool_(pool),
        lists_(Shortlists(pool, prices, options.columns)),
        table_(pool, choice),
        worth_(pool.Worth(choice)) {}

  // True if anything was exchanged.
  bool Pass() {
    bool changed = Fill();
    for (int agent = 0; agent < pool_.agents(); ++agent) {
      for (const int column : lists_[agent]) {
        if (column != table_.choice()[agent] && Try(column)) changed = true;
      }
    }
    return changed;
  }
  const TeamChoice& choice() const { return table_.choice(); }

 private:
  bool Fill() {
    bool filled = false;
    for (int agent = 0; agent < pool_.agents(); ++agent) {
      if (table_.choice()[agent] != kNobody) continue;
      const int column = table_.BestFitting(agent, pool_.columns_of(agent));
      if (column == kNobody) continue;
      table_.Put(column);
      filled = true;
    }
    if (filled) worth_ = pool_.Worth(table_.choice());
    return filled;
  }

  bool Try(int column) {
    const TeamChoice before = table_.choice();
    const int agent = pool_.columns()[column].agent;
    std::vector<int> displaced;
    table_.Remove(agent);
    const bool possible = table_.Displace(column, &displaced);
    for (const int other : displaced) Refill(other);
    const TeamWorth worth = pool_.Worth(table_.choice());
    if (possible && IsMore(worth, worth_)) {
      worth_ = worth;
      return true;
    }
    Restore(before);
    return false;
  }

  void Refill(int agent) {
    const int column = table_.BestFitting(agent, lists_[agent]);
    if (column != kNobody) table_.Put(column);
  }

  void Restore(const TeamChoice& before) {
    for (int agent = 0; agent < pool_.agents(); ++agent) {
      if (table_.choice()[agent] != before[agent]) table_.Remove(agent);
    }
    for (int agent = 0; agent < pool_.agents(); ++agent) {
      if (table_.choice()[agent] != before[agent] && before[agent] != kNobody) {
        table_.Put(before[agent]);
      }
    }
  }

  const TeamColumns& pool_;
  std::vector<std::vector<int>> lists_;
  ChoiceTable table_;
  TeamWorth worth_;
};

}  // namespace

TeamChoice ChooseGreedily(const TeamColumns& pool,
                          const std::vector<double>& prices) {
  std::vector<std::pair<double, int>> order;
  for (int agent = 0; agent < pool.agents(); ++agent) {
    for (const int column : pool.columns_of(agent)) {
      order.emplace_back(-pool.Reduced(column, prices), column);
    }
  }
  std::sort(order.begin(), order.end());
  ChoiceTable table(pool, TeamChoice(pool.agents(), kNobody));
  for (const auto& [value, column] : order) {
    if (table.choice()[pool.columns()[column].agent] == kNobody &&
        table.Fits(column)) {
      table.Put(column);
    }
  }
  return table.choice();
}

TeamChoice Exchange(const TeamColumns& pool, const std::vector<double>& prices,
                    TeamChoice choice, const ExchangeOptions& options) {
  choice.resize(pool.agents(), kNobody);
  ColumnExchanger exchanger(pool, prices, choice, options);
  for (int pass = 0; pass < options.passes; ++pass) {
    if (!exchanger.Pass()) break;
  }
  return exchanger.choice();
}

}  // namespace kg_selector
