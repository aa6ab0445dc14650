// Hash table of the solutions of a separately evaluated pattern, for joins.
// https://www.w3.org/TR/sparql11-query/#defn_algCompatibleMapping

#ifndef KG_CORE_SPARQL_JOIN_TABLE_H_
#define KG_CORE_SPARQL_JOIN_TABLE_H_

#include <cstddef>
#include <cstdint>
#include <vector>

#include "absl/container/flat_hash_map.h"
#include "absl/functional/function_ref.h"
#include "kg_core/sparql/budget.h"
#include "kg_core/sparql/expression.h"

namespace kg_core::sparql {

class JoinTable {
 public:
  // For solutions of `pattern`. The trace of each solution is the part of
  // `matched` (Evaluator::Trace; may be null) appended after construction.
  JoinTable(const GraphPattern& pattern, QueryBudget* budget,
            std::vector<Quad>* matched);

  void Add(const Row& row);
  // Calls `emit` with `row` merged with each compatible solution; `row` is
  // restored. Returns false if `emit` did (stop).
  bool Join(Row* row, absl::FunctionRef<bool(Row&)> emit);
  // True if a compatible solution shares a bound variable with `row`.
  bool HasSharing(const Row& row);

 private:
  using Index = absl::flat_hash_map<Row, std::vector<std::uint32_t>>;

  // Indices of the solutions that may be compatible with `row`.
  const std::vector<std::uint32_t>& Candidates(const Row& row);
  TermId At(std::size_t solution, std::size_t column) const {
    return cells_[solution * columns_.size() + column];
  }
  bool Agrees(std::size_t solution, const Row& row, bool* shares) const;

  std::vector<std::size_t> columns_;  // Variable of each column.
  std::vector<bool> certain_;         // Per column: bound in every solution.
  std::vector<TermId> cells_;
  std::vector<std::uint32_t> all_;
  // Hash indices, by their key columns.
  absl::flat_hash_map<std::vector<std::size_t>, Index> indices_;
  QueryBudget* budget_;
  std::vector<Quad>* matched_;
  std::size_t matched_before_;
  std::vector<std::vector<Quad>> matched_of_;  // Per solution, if traced.
};

}  // namespace kg_core::sparql

#endif  // KG_CORE_SPARQL_JOIN_TABLE_H_
