// Linear programs: relaxation by Clp, 0/1 solution by CBC. The only unit of
// packing that uses the solvers.

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
  std::vector<double> objective;  // Coefficient by variable.
  // The first `binaries` variables are 0 or 1 (in [0, 1] in the relaxation),
  // the others are free.
  int binaries = 0;
  std::vector<LinearRow> rows;
};

struct LinearRelaxation {
  bool solved = false;
  double value = std::numeric_limits<double>::infinity();
  std::vector<double> values;  // Value by variable.
  // Reduced cost by variable: gain per unit increase.
  std::vector<double> reduced_costs;
  std::vector<double> row_prices;  // Price by row, >= 0.
};
LinearRelaxation Relax(const LinearProgram& program);

struct BinaryOptions {
  double time_limit_s = std::numeric_limits<double>::infinity();
  bool processor_time = false;
  // Cutoff: only solutions worth more than this are sought.
  double better_than = -std::numeric_limits<double>::infinity();
};
struct BinarySolution {
  std::vector<bool> chosen;  // By binary variable; empty = no better solution.
  bool finished = false;     // The search was exhaustive.
  double bound = std::numeric_limits<double>::infinity();
};
BinarySolution SolveBinary(const LinearProgram& program,
                           const BinaryOptions& options);

// Time that counts against a limit: of this process, or wall-clock time [s].
double ClockNow_s(bool processor_time);

}  // namespace kg_selector

#endif  // KG_SELECTOR_PACKING_LINEAR_PROGRAM_H_
