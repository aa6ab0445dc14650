// The exact choice among columns. A column is one thing that an agent may do,
// with its score and the rows it uses up: set packing with capacities.
//
//   maximise  sum of score_c x_c                 x_c = 0 or 1
//   such that sum over columns c using row r  x_c <= capacity_r
//             sum over columns c of agent a   x_c <= count_a
//             x_c + x_d <= 1                     for each conflict (c, d)
//
// Distinct agents have count 1; agents that may swap their columns are one
// agent of a larger count. Nobody is forced to have a column.
//
// A start by greedy choice and exchange, the linear relaxation by Clp, columns
// dropped whose reduced cost cannot make up for their bound, and CBC for what
// is left. Conflicts become cliques, which the relaxation likes better.
// Columns are taken in their order: the same problem gives the same answer,
// unless the time limit ends it.
//
//   Packing packing;
//   packing.agent_counts = {1, 1};      // Two distinct agents.
//   packing.row_capacities = {1};       // One row of capacity 1.
//   packing.columns = {{0, 5.0, {0}}, {0, 3.0, {}}, {1, 4.0, {0}}};
//   SolvePacking(packing, {}).chosen    // {1, 2}: 3 + 4 beats 5.
//
// Fairness, between distinct agents (all counts 1). An agent's load is that of
// its column, 0 if it has none; agents that no column names are left out.
//   kMaxMin   first the least load as large as can be, then the score
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
  std::vector<int> rows = {};  // Uses one unit of each; none twice.
  double load = 0.0;           // Read only for fairness.
};

enum class Fairness { kNone, kMaxMin, kBalance };

struct Packing {
  std::vector<int> agent_counts;    // >= 0.
  std::vector<int> row_capacities;  // >= 0.
  std::vector<Column> columns;
  std::vector<std::pair<int, int>> conflicts = {};  // Columns, never both.
  Fairness fairness = Fairness::kNone;
  double weight = 0.0;  // >= 0; of kBalance.
};

struct PackingOptions {
  double time_limit_s = std::numeric_limits<double>::infinity();
  // The limit is processor time of this process, else wall-clock time.
  bool processor_time = false;
  std::vector<int> start = {};  // Columns to start from; must be a packing.
};

struct PackingChoice {
  std::vector<int> chosen;  // Columns, ascending.
  double objective = 0.0;   // What is maximised; with kMaxMin the score.
  double min_load = 0.0;    // Over the agents that columns name.
  bool optimal = false;     // Proven; false: the time limit was hit first.
  // No choice has a larger objective; with kMaxMin none whose least load is as
  // large as this one's.
  double bound = std::numeric_limits<double>::infinity();
};

// Throws std::invalid_argument naming the column or row if an index is out of
// range, a number not finite or negative where it may not be, a row twice in
// one column, or fairness asked for between agents of which there are several.
void Check(const Packing& packing);

// Throws as Check() does, and if `start` is no packing.
PackingChoice SolvePacking(const Packing& packing,
                           const PackingOptions& options);

// What a unit of each row, and each agent, is worth at the optimum of the
// linear relaxation (>= 0): a further column, in conflict with none, is worth
// adding only if its score is above its agent's price and those of its rows.
struct PackingPrices {
  std::vector<double> rows;
  std::vector<double> agents;
  double bound = 0.0;  // The relaxation's value: no choice is worth more.
};
// Fairness is not counted.
PackingPrices PriceRows(const Packing& packing);

// Greedy by score, then exchanges of one column for those in its way while that
// pays; starts from `start`. What SolvePacking() begins with; fairness is not
// counted.
std::vector<int> PackQuickly(const Packing& packing,
                             const std::vector<int>& start);

// What `chosen` is worth, as SolvePacking() counts it.
double ComputeObjective(const Packing& packing, const std::vector<int>& chosen);
bool IsPacking(const Packing& packing, const std::vector<int>& chosen);

}  // namespace kg_selector

#endif  // KG_SELECTOR_PACKING_PACKING_H_
