// What a query may still use up; checked in every inner loop.

#ifndef KG_CORE_SPARQL_BUDGET_H_
#define KG_CORE_SPARQL_BUDGET_H_

#include <chrono>
#include <cstddef>

#include "kg_core/sparql/limits.h"

namespace kg_core::sparql {

class QueryBudget {
 public:
  explicit QueryBudget(const QueryLimits& limits);

  // One step of any loop; throws InputError once the time is over.
  void Step() {
    if ((++steps_ & 1023u) == 0) CheckTime();
  }
  // Memory that lives until the query ends; throws InputError.
  void UseWorkingBytes(std::size_t bytes);
  // One row of the result; throws InputError.
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
