// Linear programs, their relaxation by Clp and their solution in zeros and ones
// by CBC: the part of packing that knows the solvers.

#ifndef KG_SELECTOR_PACKING_LINEAR_PROGRAM_H_
#define KG_SELECTOR_PACKING_LINEAR_PROGRAM_H_

#include <limits>
#include <utility>
#include <vector>

namespace kg_selector {

// maximise sum of objective_j x_j, such that for each row
// sum of coefficient x_j <= at_most.
struct LinearRow {
  std::vector<std::pair<int, double>> terms;  // (variable, coefficient)
  double at_most = 0.0;
};
struct LinearProgram {
  std::vector<double> objective;  // By variable.
  // The first so many variables are 0 or 1 (in the relaxation between), the
  // others any number.
  int binaries = 0;
  std::vector<LinearRow> rows;
};

struct LinearRelaxation {
  bool solved = false;
  double value = std::numeric_limits<double>::infinity();
  std::vector<double> values;         // By variable.
  std::vector<double> reduced_costs;  // By variable; gain of a unit more.
  std::vector<double> row_prices;     // By row, >= 0.
};
LinearRelaxation Relax(const LinearProgram& program);

struct BinaryOptions {
  double time_limit_s = std::numeric_limits<double>::infinity();
  bool processor_time = false;
  // Only what is worth more than this is looked for.
  double better_than = -std::numeric_limits<double>::infinity();
};
struct BinarySolution {
  std::vector<bool> chosen;  // By binary; empty: nothing better was found.
  bool finished = false;     // The search was exhaustive.
  double bound = std::numeric_limits<double>::infinity();
};
BinarySolution SolveBinary(const LinearProgram& program,
                           const BinaryOptions& options);

// Time that counts against a limit: of this process, or wall-clock time [s].
double ClockNow_s(bool processor_time);

}  // namespace kg_selector

#endif  // KG_SELECTOR_PACKING_LINEAR_PROGRAM_H_
