// Aggregates (SPARQL set functions) of one group.
// https://www.w3.org/TR/sparql11-query/#setFunctions

#ifndef KG_CORE_SPARQL_AGGREGATION_H_
#define KG_CORE_SPARQL_AGGREGATION_H_

#include <cstddef>
#include <optional>
#include <string>

#include "absl/container/flat_hash_set.h"
#include "kg_core/sparql/expression.h"
#include "kg_core/sparql/values.h"

namespace kg_core::sparql {

// The running state of one aggregate.
class AggregateAccumulator {
 public:
  AggregateAccumulator(const AggregateCall* aggregate, TermTable* terms,
                       QueryBudget* budget)
      : aggregate_(aggregate), terms_(terms), budget_(budget) {}

  // Adds a value; kNoTerm stands for an error or an unbound variable.
  void Add(TermId value);
  // Adds a whole solution, for COUNT(*).
  void AddRow(const Row& row);
  // The value; nullopt is SPARQL's error: the variable stays unbound.
  std::optional<Term> Result() const;

 private:
  void AddNumber(const Term& term);
  void AddText(const Term& term);

  const AggregateCall* aggregate_;
  TermTable* terms_;
  QueryBudget* budget_;
  std::size_t count_ = 0;
  bool error_ = false;
  std::optional<XsdNumber> sum_;
  TermId best_ = kNoTerm;
  std::string text_;
  bool has_blank_ = false;            // Among the values of GROUP_CONCAT.
  absl::flat_hash_set<TermId> seen_;  // Values seen so far, for DISTINCT.
  absl::flat_hash_set<Row> seen_rows_;
};

}  // namespace kg_core::sparql

#endif  // KG_CORE_SPARQL_AGGREGATION_H_
