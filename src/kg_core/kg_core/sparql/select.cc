// SELECT: grouping, projection, order, DISTINCT, OFFSET and LIMIT.
// https://www.w3.org/TR/sparql11-query/#convertSolMod

#include <algorithm>
#include <utility>

#include "kg_core/sparql/aggregation.h"
#include "kg_core/sparql/evaluator.h"
#include "kg_core/sparql/matched_scope.h"
#include "kg_core/sparql/values.h"

namespace kg_core::sparql {
namespace {

// Estimated memory per distinct sort key while ranking, in bytes.
constexpr std::size_t kBytesPerKey = 224;

TermId& Slot(Row* row, int variable) {
  return (*row)[static_cast<std::size_t>(variable)];
}

}  // namespace

struct PatternEvaluator::Sorted {
  std::vector<TermId> keys;  // Replaced by ranks in RankKeys.
  Row row;
};

// Returns false only if `emit` stopped the evaluation, not if LIMIT was
// reached.
bool PatternEvaluator::RunSelect(const SelectQuery& select,
                                 const ActiveGraph& g, Emit emit) {
  absl::flat_hash_set<Row> seen;
  std::size_t skipped = 0;
  std::size_t given = 0;
  bool go_on = true;
  Row projected(query_->variables.size(), kNoTerm);
  const auto project = [&](Row& row) {
    // Order given by the recommendation: projection, DISTINCT, OFFSET, LIMIT.
    if (select.limit && given >= *select.limit) return false;
    for (const SelectColumn& column : select.columns) {
      Slot(&projected, column.variable) = Slot(&row, column.variable);
    }
    if (select.distinct) {
      if (!seen.insert(projected).second) return true;
      budget_->UseWorkingBytes(2 * sizeof(TermId) * (projected.size() + 8));
    }
    if (skipped < select.offset) {
      ++skipped;
      return true;
    }
    ++given;
    go_on = emit(projected);
    return go_on && !(select.limit && given >= *select.limit);
  };
  if (select.limit && *select.limit == 0) return true;
  if (select.order_by.empty()) {
    Solutions(select, g, project);
    return go_on;
  }
  for (Sorted& sorted : SortedSolutions(select, g)) {
    if (!project(sorted.row)) break;
  }
  return go_on;
}

// https://www.w3.org/TR/sparql11-query/#modOrderBy
std::vector<PatternEvaluator::Sorted> PatternEvaluator::SortedSolutions(
    const SelectQuery& select, const ActiveGraph& g) {
  std::vector<Sorted> all;
  Solutions(select, g, [&](Row& row) {
    Sorted sorted{{}, row};
    for (const OrderKey& key : select.order_by) {
      sorted.keys.push_back(expressions_.Evaluate(key.expression, {row, g}));
    }
    budget_->UseWorkingBytes(sizeof(Sorted) +
                             2 * sizeof(TermId) * (row.size() + 16));
    all.push_back(std::move(sorted));
    return true;
  });
  RankKeys(&all);
  std::stable_sort(
      all.begin(), all.end(), [&](const Sorted& a, const Sorted& b) {
        budget_->Step();
        for (std::size_t i = 0; i < a.keys.size(); ++i) {
          if (a.keys[i] == b.keys[i]) continue;
          return (a.keys[i] < b.keys[i]) != select.order_by[i].descending;
        }
        return false;
      });
  return all;
}

// Replaces each key by its rank among all keys; 0 for an unbound key.
void PatternEvaluator::RankKeys(std::vector<Sorted>* all) {
  // Rank the distinct terms once; sorting then compares integers. Rank 0 is
  // unbound, which sorts first.
  absl::flat_hash_map<TermId, std::size_t> places;
  std::vector<const Term*> terms;
  for (const Sorted& sorted : *all) {
    for (const TermId key : sorted.keys) {
      budget_->Step();
      if (key == kNoTerm || !places.emplace(key, terms.size()).second) continue;
      terms.push_back(&terms_->Get(key));
    }
  }
  budget_->UseWorkingBytes(kBytesPerKey * terms.size());
  const std::vector<int> ranks =
      ComputeRanks(terms, [this] { budget_->Step(); });
  for (Sorted& sorted : *all) {
    for (TermId& key : sorted.keys) {
      if (key == kNoTerm) continue;
      key = 1 + static_cast<TermId>(ranks[places.at(key)]);
    }
  }
}

// Solutions with evaluated column expressions, before ordering and projection.
bool PatternEvaluator::Solutions(const SelectQuery& select,
                                 const ActiveGraph& g, Emit emit) {
  const auto finish = [&](Row& row) {
    return FinishRow(select, g, &row, emit);
  };
  if (select.grouped) return Grouped(select, g, finish);
  Row row(query_->variables.size(), kNoTerm);
  return Evaluate(select.where, g, &row, finish);
}

// Applies HAVING, then evaluates the column expressions.
bool PatternEvaluator::FinishRow(const SelectQuery& select,
                                 const ActiveGraph& g, Row* row, Emit emit) {
  if (!HoldAll(select.having, g, row)) return true;
  bool extended = false;
  for (const SelectColumn& column : select.columns) {
    if (!column.expression) continue;
    if (!extended) expressions_.BeginRow();
    extended = true;
    Slot(row, column.variable) =
        expressions_.Evaluate(*column.expression, {*row, g});
  }
  const bool go_on = emit(*row);
  for (const SelectColumn& column : select.columns) {
    if (column.expression) Slot(row, column.variable) = kNoTerm;
  }
  return go_on;
}

struct PatternEvaluator::Group {
  Row key;
  std::vector<AggregateAccumulator> values;
  std::vector<Quad> matched;  // Matched triples, if traced.
};

PatternEvaluator::Group PatternEvaluator::NewGroup(const SelectQuery& select,
                                                   const Row& key) {
  Group group{key, {}, {}};
  for (const AggregateCall& aggregate : select.aggregates) {
    group.values.emplace_back(&aggregate, terms_, budget_);
  }
  budget_->UseWorkingBytes(
      sizeof(Group) + sizeof(AggregateAccumulator) * select.aggregates.size() +
      4 * sizeof(TermId) * (key.size() + 8));
  return group;
}

// https://www.w3.org/TR/sparql11-query/#aggregateAlgebra
bool PatternEvaluator::Grouped(const SelectQuery& select, const ActiveGraph& g,
                               Emit emit) {
  std::vector<Group> groups;  // In order of appearance.
  absl::flat_hash_map<Row, std::size_t> numbers;
  const auto group_of = [&](const Row& key) -> Group& {
    const auto [found, is_new] = numbers.emplace(key, groups.size());
    if (is_new) groups.push_back(NewGroup(select, key));
    return groups[found->second];
  };
  if (select.group_by.empty()) group_of({});  // One group, even if empty.
  const std::size_t before = matched_ == nullptr ? 0 : matched_->size();
  Row start(query_->variables.size(), kNoTerm);
  Evaluate(select.where, g, &start, [&](Row& row) {
    Row key;
    for (const SelectColumn& column : select.group_by) {
      key.push_back(column.expression
                        ? expressions_.Evaluate(*column.expression, {row, g})
                        : Slot(&row, column.variable));
    }
    Group& group = group_of(key);  // Accumulates this solution.
    if (matched_ != nullptr) {
      budget_->UseWorkingBytes(sizeof(Quad) * (matched_->size() - before));
      const std::vector<Quad> more = MatchedSince(*matched_, before);
      group.matched.insert(group.matched.end(), more.begin(), more.end());
    }
    for (std::size_t i = 0; i < select.aggregates.size(); ++i) {
      const AggregateCall& aggregate = select.aggregates[i];
      if (aggregate.argument) {
        group.values[i].Add(
            expressions_.Evaluate(*aggregate.argument, {row, g}));
      } else {
        group.values[i].AddRow(row);
      }
    }
    return true;
  });
  Row row(query_->variables.size(), kNoTerm);
  for (const Group& group : groups) {  // One solution per group.
    for (std::size_t i = 0; i < group.key.size(); ++i) {
      Slot(&row, select.group_by[i].variable) = group.key[i];
    }
    for (std::size_t i = 0; i < group.values.size(); ++i) {
      const std::optional<Term> value = group.values[i].Result();
      Slot(&row, select.aggregates[i].variable) =
          value ? terms_->Intern(*value) : kNoTerm;
    }
    const MatchedScope scope(matched_);
    scope.Append(group.matched);
    if (!emit(row)) return false;
  }
  return true;
}

}  // namespace kg_core::sparql
