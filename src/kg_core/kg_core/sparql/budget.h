// Remaining time, memory and rows of a query; checked in every inner loop.

#ifndef KG_CORE_SPARQL_BUDGET_H_
#define KG_CORE_SPARQL_BUDGET_H_

#include <chrono>
#include <cstddef>

#include "kg_core/sparql/limits.h"

namespace kg_core::sparql {

class QueryBudget {
 public:
  explicit QueryBudget(const QueryLimits& limits);

  // Counts one loop step; throws InputError once the time limit is exceeded.
  void Step() {
    if ((++steps_ & 1023u) == 0) CheckTime();
  }
  // Accounts for memory held until the query ends; throws InputError above the
  // limit.
  void UseWorkingBytes(std::size_t bytes);
  // Accounts for one result row; throws InputError above the limits.
  void AddResultRow(std::size_t bytes);

 private:
  void CheckTime() const;

  QueryLimits limits_;
  std::chrono::steady_clock::time_point end_;
  std::size_t steps_ = 0;
  std::size_t working_bytes_ = 0;
  std::size_t result_bytes_ = 0;
  std::size_t rows_ = 0;
};

}  // namespace kg_core::sparql

#endif  // KG_CORE_SPARQL_BUDGET_H_
