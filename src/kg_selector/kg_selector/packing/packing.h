// Exact choice among columns. A column is one option of an agent, with its
// score and the rows it uses: set packing with capacities.
//
//   maximise  sum of score_c x_c                 x_c = 0 or 1
//   such that sum over columns c using row r  x_c <= capacity_r
//             sum over columns c of agent a   x_c <= count_a
//             x_c + x_d <= 1                     for each conflict (c, d)
//
// Distinct agents have count 1; interchangeable agents are one agent with a
// larger count. An agent may be left without a column.
//
// Method: greedy start with exchanges; linear relaxation by Clp; columns are
// dropped by reduced cost; CBC solves the rest. Conflicts become cliques, which
// tighten the relaxation. Deterministic in the order of the columns, unless the
// time limit stops the search.
//
//   Packing packing;
//   packing.agent_counts = {1, 1};      // Two distinct agents.
//   packing.row_capacities = {1};       // One row of capacity 1.
//   packing.columns = {{0, 5.0, {0}}, {0, 3.0, {}}, {1, 4.0, {0}}};
//   SolvePacking(packing, {}).chosen    // {1, 2}: 3 + 4 beats 5.
//
// Fairness, between distinct agents (all counts 1). An agent's load is that of
// its column, 0 if it has none; agents that no column names are left out.
//   kMaxMin   maximise the smallest load, then the score
//   kBalance  maximise score - weight (largest load - smallest load)

#ifndef KG_SELECTOR_PACKING_PACKING_H_
#define KG_SELECTOR_PACKING_PACKING_H_

#include <limits>
#include <utility>
#include <vector>

namespace kg_selector {

struct Column {
  int agent = 0;
  double score = 0.0;
  std::vector<int> rows = {};  // Rows used, one unit each; no duplicates.
  double load = 0.0;           // Used for fairness only.
};

enum class Fairness { kNone, kMaxMin, kBalance };

struct Packing {
  std::vector<int> agent_counts;    // >= 0.
  std::vector<int> row_capacities;  // >= 0.
  std::vector<Column> columns;
  // Pairs of mutually exclusive columns.
  std::vector<std::pair<int, int>> conflicts = {};
  Fairness fairness = Fairness::kNone;
  double weight = 0.0;  // Weight of kBalance, >= 0.
};

struct PackingOptions {
  double time_limit_s = std::numeric_limits<double>::infinity();
  // The limit is processor time of this process, else wall-clock time.
  bool processor_time = false;
  std::vector<int> start = {};  // Initial columns; must be a packing.
};

struct PackingChoice {
  std::vector<int> chosen;  // Columns, ascending.
  double objective = 0.0;   // Maximised value; with kMaxMin the score.
  double min_load = 0.0;    // Over the agents that have columns.
  bool optimal = false;     // Proven optimal; false = stopped by time limit.
  // Upper bound of the objective; with kMaxMin, among choices whose smallest
  // load is at least this one's.
  double bound = std::numeric_limits<double>::infinity();
};

// Throws std::invalid_argument naming the column or row if an index is out of
// range, a number is not finite or wrongly negative, a column repeats a row, or
// fairness is requested for an agent with count > 1.
void Check(const Packing& packing);

// Throws as Check() does, and if `start` is not a packing.
PackingChoice SolvePacking(const Packing& packing,
                           const PackingOptions& options);

// Prices (>= 0) of a unit of each row and of each agent at the optimum of the
// linear relaxation: a further column without conflicts is worth adding only if
// its score exceeds its agent's price plus the prices of its rows.
struct PackingPrices {
  std::vector<double> rows;
  std::vector<double> agents;
  double bound = 0.0;  // Value of the relaxation: upper bound of any choice.
};
// Ignores fairness.
PackingPrices PriceRows(const Packing& packing);

// Heuristic from `start`: greedy by score, then exchanges of one column for the
// columns that block it while the score improves. First step of SolvePacking();
// ignores fairness.
std::vector<int> PackQuickly(const Packing& packing,
                             const std::vector<int>& start);

// Objective of `chosen`, as in SolvePacking().
double ComputeObjective(const Packing& packing, const std::vector<int>& chosen);
bool IsPacking(const Packing& packing, const std::vector<int>& chosen);

}  // namespace kg_selector

#endif  // KG_SELECTOR_PACKING_PACKING_H_
