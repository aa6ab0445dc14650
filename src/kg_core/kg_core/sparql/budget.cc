#include "kg_core/sparql/budget.h"

#include <cstdio>
#include <string>

#include "kg_base/common/limit_error.h"

namespace kg_core::sparql {
namespace {

using kg_base::LimitError;

using Clock = std::chrono::steady_clock;

// Limits that are NaN or longer than a day are clamped to one day.
Clock::time_point GetEnd(double seconds) {
  constexpr double kDay_s = 86400.0;
  const double limited = seconds < kDay_s ? seconds : kDay_s;
  return Clock::now() + std::chrono::duration_cast<Clock::duration>(
                            std::chrono::duration<double>(limited));
}

}  // namespace

QueryBudget::QueryBudget(const QueryLimits& limits)
    : limits_(limits), end_(GetEnd(limits.seconds)) {}

void QueryBudget::CheckTime() const {
  if (Clock::now() < end_) return;
  char text[96];
  std::snprintf(text, sizeof text,
                "the query took longer than the limit of %g s",
                limits_.seconds);
  throw LimitError(text);
}

void QueryBudget::UseWorkingBytes(std::size_t bytes) {
  working_bytes_ += bytes;
  if (working_bytes_ <= limits_.working_bytes) return;
  throw LimitError("the query needs more memory than the limit of " +
                   std::to_string(limits_.working_bytes) + " bytes");
}

void QueryBudget::AddResultRow(std::size_t bytes) {
  if (++rows_ > limits_.rows) {
    throw LimitError("the result has more rows than the limit of " +
                     std::to_string(limits_.rows));
  }
  result_bytes_ += bytes;
  if (result_bytes_ <= limits_.bytes) return;
  throw LimitError("the result has more bytes than the limit of " +
                   std::to_string(limits_.bytes));
}

}  // namespace kg_core::sparql
