#include "kg_selector/packing/packing.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

#include "kg_selector/packing/linear_program.h"
#include "kg_selector/packing/packing_cliques.h"

namespace kg_selector {
namespace {

bool IsIndex(int index, std::size_t size) {
  return index >= 0 && index < static_cast<int>(size);
}

// Load of each agent that has columns; 0 if none is chosen.
std::map<int, double> AgentLoads(const Packing& packing,
                                 const std::vector<int>& chosen) {
  std::map<int, double> loads;
  for (const Column& column : packing.columns) loads[column.agent] = 0.0;
  for (int c : chosen) {
    loads[packing.columns[c].agent] += packing.columns[c].load;
  }
  return loads;
}

struct LoadExtent {
  double min_value = 0.0;
  double largest = 0.0;
};
LoadExtent ComputeExtent(const std::map<int, double>& loads) {
  if (loads.empty()) return {};
  const auto [min_value, largest] =
      std::minmax_element(loads.begin(), loads.end(),
                          [](auto& a, auto& b) { return a.second < b.second; });
  return {min_value->second, largest->second};
}

using Terms = std::vector<std::pair<int, double>>;

// Order of rows: rows, agents, cliques of conflicts.
LinearProgram ToProgram(const Packing& packing) {
  LinearProgram program;
  const int columns = static_cast<int>(packing.columns.size());
  program.binaries = columns;
  for (int count : packing.row_capacities) {
    program.rows.push_back({{}, static_cast<double>(count)});
  }
  const std::size_t agents = program.rows.size();
  for (int count : packing.agent_counts) {
    program.rows.push_back({{}, static_cast<double>(count)});
  }
  // A column is 1 in each row it uses and in the row of its agent.
  for (int c = 0; c < columns; ++c) {
    const Column& column = packing.columns[c];
    program.objective.push_back(column.score);
    for (int row : column.rows) program.rows[row].terms.push_back({c, 1.0});
    program.rows[agents + column.agent].terms.push_back({c, 1.0});
  }
  for (const auto& clique : FindCliques(columns, packing.conflicts)) {
    Terms terms;
    for (int c : clique) terms.push_back({c, 1.0});
    program.rows.push_back({std::move(terms), 1.0});
  }
  return program;
}

// Two more variables, upper and lower bound of all loads; their difference is
// charged.
void AddBalance(const Packing& packing, LinearProgram* program) {
  std::map<int, Terms> loads;
  for (std::size_t c = 0; c < packing.columns.size(); ++c) {
    const Column& column = packing.columns[c];
    loads[column.agent].push_back({static_cast<int>(c), column.load});
  }
  if (loads.empty() || packing.weight == 0.0) return;
  const int largest = static_cast<int>(program->objective.size());
  const int min_value = largest + 1;
  program->objective.push_back(-packing.weight);
  program->objective.push_back(packing.weight);
  for (const auto& [agent, terms] : loads) {
    // load - largest <= 0 and least - load <= 0.
    LinearRow below{terms, 0.0};
    below.terms.push_back({largest, -1.0});
    LinearRow above{{}, 0.0};
    for (const auto& [c, load] : terms) above.terms.push_back({c, -load});
    above.terms.push_back({min_value, 1.0});
    program->rows.push_back(std::move(below));
    program->rows.push_back(std::move(above));
  }
}

// The program without columns that cannot be part of a solution better than
// `value`; `kept` receives the remaining indices.
LinearProgram Reduced(const LinearProgram& program,
                      const LinearRelaxation& relaxed, double value,
                      std::vector<int>* kept) {
  LinearProgram reduced;
  std::vector<int> renumbered(program.objective.size(), -1);
  for (int j = 0; j < static_cast<int>(program.objective.size()); ++j) {
    const bool binary = j < program.binaries;
    // Reduced cost fixing: with x_j = 1 the program is worth at most relaxation
    // + reduced cost. The slack covers Clp's tolerance (1e-7).
    const double slack = 1e-7 * (1.0 + std::abs(value));
    if (binary && relaxed.solved &&
        relaxed.value + relaxed.reduced_costs[j] < value - slack) {
      continue;
    }
    renumbered[j] = static_cast<int>(reduced.objective.size());
    reduced.objective.push_back(program.objective[j]);
    if (binary) kept->push_back(j);
  }
  reduced.binaries = static_cast<int>(kept->size());
  // Rows without the dropped columns.
  for (const LinearRow& row : program.rows) {
    LinearRow shorter{{}, row.at_most};
    for (const auto& [j, coefficient] : row.terms) {
      if (renumbered[j] < 0) continue;
      shorter.terms.push_back({renumbered[j], coefficient});
    }
    if (!shorter.terms.empty()) reduced.rows.push_back(std::move(shorter));
  }
  return reduced;
}

// Deadline on the clock selected by the options.
class SolveDeadline {
 public:
  explicit SolveDeadline(const PackingOptions& options)
      : options_(options), begin_s_(ClockNow_s(options.processor_time)) {}
  double left_s() const {
    return options_.time_limit_s -
           (ClockNow_s(options_.processor_time) - begin_s_);
  }
  BinaryOptions Options(double better_than) const {
    return {left_s(), options_.processor_time, better_than};
  }

 private:
  const PackingOptions& options_;
  const double begin_s_;
};

std::vector<int> WholeColumns(const LinearRelaxation& relaxed, int binaries) {
  std::vector<int> chosen;
  for (int c = 0; c < binaries; ++c) {
    if (relaxed.values[c] > 0.5) chosen.push_back(c);
  }
  return chosen;
}

// A packing to improve. `all_served`: every agent that columns name must have a
// column.
struct PackingTask {
  const Packing& packing;
  bool all_served = false;
};

void AcceptIfBetter(const PackingTask& task, const std::vector<int>& chosen,
                    PackingChoice* best) {
  if (!IsPacking(task.packing, chosen)) return;
  if (task.all_served && chosen.size() != AgentLoads(task.packing, {}).size()) {
    return;
  }
  const double objective = ComputeObjective(task.packing, chosen);
  if (!(objective > best->objective)) return;
  best->chosen = chosen;
  best->objective = objective;
}

bool IsProven(const PackingChoice& best) {
  return best.bound <= best.objective + 1e-9 * (1.0 + std::abs(best.objective));
}

LinearProgram ToProgram(const PackingTask& task) {
  LinearProgram program = ToProgram(task.packing);
  if (task.packing.fairness == Fairness::kBalance) {
    AddBalance(task.packing, &program);
  }
  if (!task.all_served) return program;
  std::map<int, Terms> columns;
  for (std::size_t c = 0; c < task.packing.columns.size(); ++c) {
    columns[task.packing.columns[c].agent].push_back(
        {static_cast<int>(c), -1.0});
  }
  for (auto& [agent, terms] : columns) {
    program.rows.push_back({std::move(terms), -1.0});
  }
  return program;
}

// Improves `best` by score, or by the objective of kBalance.
void Solve(const PackingTask& task, const SolveDeadline& deadline,
           PackingChoice* best) {
  const LinearProgram program = ToProgram(task);
  const LinearRelaxation relaxed = Relax(program);
  if (relaxed.solved) {
    best->bound = relaxed.value;
    AcceptIfBetter(task, WholeColumns(relaxed, program.binaries), best);
  }
  // Step 1: the relaxation gives a bound, and possibly an integral solution.
  best->optimal = IsProven(*best);
  if (best->optimal || deadline.left_s() <= 0.0) return;
  // Step 2: branch and cut on the remaining columns.
  std::vector<int> kept;
  const LinearProgram reduced =
      Reduced(program, relaxed, best->objective, &kept);
  const BinarySolution solution =
      SolveBinary(reduced, deadline.Options(best->objective));
  std::vector<int> chosen;
  for (std::size_t i = 0; i < solution.chosen.size(); ++i) {
    if (solution.chosen[i]) chosen.push_back(kept[i]);
  }
  AcceptIfBetter(task, chosen, best);
  best->optimal = solution.finished;
  const double bound = std::min(best->bound, solution.bound);
  best->bound =
      solution.finished ? best->objective : std::max(best->objective, bound);
}

// The packing restricted to columns of at least this load.
Packing WithMinimumLoad(const Packing& packing, double load,
                        std::vector<int>* kept) {
  Packing part = packing;
  part.fairness = Fairness::kNone;
  part.columns.clear();
  part.conflicts.clear();
  std::vector<int> renumbered(packing.columns.size(), -1);
  for (std::size_t c = 0; c < packing.columns.size(); ++c) {
    if (packing.columns[c].load < load) continue;
    renumbered[c] = static_cast<int>(part.columns.size());
    part.columns.push_back(packing.columns[c]);
    kept->push_back(static_cast<int>(c));
  }
  for (const auto& [a, b] : packing.conflicts) {
    if (renumbered[a] < 0 || renumbered[b] < 0) continue;
    part.conflicts.push_back({renumbered[a], renumbered[b]});
  }
  return part;
}

struct LoadAttempt {
  std::vector<int> chosen;
  bool all_served = false;  // Every agent has a column.
  bool proven = false;
};

// Whether every agent can have a column of at least this load.
LoadAttempt TryLoad(const Packing& packing, double load,
                    const SolveDeadline& deadline) {
  std::vector<int> kept;
  Packing part = WithMinimumLoad(packing, load, &kept);
  for (Column& column : part.columns) column.score = 1.0;
  PackingChoice best;
  best.chosen = PackQuickly(part, {});
  best.objective = ComputeObjective(part, best.chosen);
  Solve({part}, deadline, &best);
  LoadAttempt attempt;
  for (int c : best.chosen) attempt.chosen.push_back(kept[c]);
  attempt.all_served = best.chosen.size() == AgentLoads(packing, {}).size();
  attempt.proven = best.optimal;
  return attempt;
}

// Best score among columns of at least this load, started from such a choice.
// If the load is above 0 every agent needs a column, because without one its
// load is 0.
PackingChoice BestWithLoad(const Packing& packing, double load,
                           const std::vector<int>& start,
                           const SolveDeadline& deadline) {
  std::vector<int> kept;
  const Packing part = WithMinimumLoad(packing, load, &kept);
  PackingChoice best;
  for (int c : start) {
    const auto at = std::lower_bound(kept.begin(), kept.end(), c);
    best.chosen.push_back(static_cast<int>(at - kept.begin()));
  }
  best.objective = ComputeObjective(part, best.chosen);
  Solve({part, load > 0.0}, deadline, &best);
  for (int& c : best.chosen) c = kept[c];
  return best;
}

std::vector<double> PositiveLoads(const Packing& packing) {
  std::set<double> loads;
  for (const Column& column : packing.columns) {
    if (column.load > 0.0) loads.insert(column.load);
  }
  return {loads.begin(), loads.end()};
}

bool IsFairer(const Packing& packing, const PackingChoice& a,
              const PackingChoice& b) {
  const double least_a = ComputeExtent(AgentLoads(packing, a.chosen)).min_value;
  const double least_b = ComputeExtent(AgentLoads(packing, b.chosen)).min_value;
  if (least_a != least_b) return least_a > least_b;
  return ComputeObjective(packing, a.chosen) >
         ComputeObjective(packing, b.chosen);
}

// Bisection for the largest load that every agent can reach; then the best
// score at that load.
PackingChoice SolveMaxMin(const Packing& packing, const std::vector<int>& start,
                          const SolveDeadline& deadline) {
  const std::vector<double> loads = PositiveLoads(packing);
  std::size_t possible = 0;  // Loads below this index are feasible.
  std::size_t impossible = loads.size();
  bool proven = true;
  std::vector<int> all_served;
  while (possible < impossible) {
    const std::size_t middle = possible + (impossible - possible) / 2;
    const LoadAttempt attempt = TryLoad(packing, loads[middle], deadline);
    if (attempt.all_served) {
      all_served = attempt.chosen;
      possible = middle + 1;
    } else {
      proven = proven && attempt.proven;
      impossible = middle;
    }
  }
  const double load = possible == 0 ? 0.0 : loads[possible - 1];
  PackingChoice best = BestWithLoad(packing, load, all_served, deadline);
  best.optimal = best.optimal && proven;
  for (const auto& other : {start, PackQuickly(packing, start)}) {
    PackingChoice chosen;
    chosen.chosen = other;
    if (!best.optimal && IsFairer(packing, chosen, best)) best = chosen;
  }
  return best;
}

}  // namespace

double ComputeObjective(const Packing& packing,
                        const std::vector<int>& chosen) {
  double sum = 0.0;
  for (int c : chosen) sum += packing.columns[c].score;
  if (packing.fairness != Fairness::kBalance) return sum;
  const LoadExtent extent = ComputeExtent(AgentLoads(packing, chosen));
  return sum - packing.weight * (extent.largest - extent.min_value);
}

bool IsPacking(const Packing& packing, const std::vector<int>& chosen) {
  std::set<int> columns;
  std::vector<int> agents = packing.agent_counts;
  std::vector<int> rows = packing.row_capacities;
  for (int c : chosen) {
    if (!IsIndex(c, packing.columns.size()) || !columns.insert(c).second) {
      return false;
    }
    if (--agents[packing.columns[c].agent] < 0) return false;
    for (int row : packing.columns[c].rows) {
      if (--rows[row] < 0) return false;
    }
  }
  return std::none_of(packing.conflicts.begin(), packing.conflicts.end(),
                      [&](const std::pair<int, int>& conflict) {
                        return columns.count(conflict.first) > 0 &&
                               columns.count(conflict.second) > 0;
                      });
}

PackingPrices PriceRows(const Packing& packing) {
  Check(packing);
  PackingPrices prices;
  const LinearRelaxation relaxed = Relax(ToProgram(packing));
  if (!relaxed.solved) throw std::logic_error("a packing without relaxation");
  const auto rows = relaxed.row_prices.begin();
  const std::size_t count = packing.row_capacities.size();
  prices.rows.assign(rows, rows + count);
  prices.agents.assign(rows + count,
                       rows + count + packing.agent_counts.size());
  prices.bound = relaxed.value;
  return prices;
}

PackingChoice SolvePacking(const Packing& packing,
                           const PackingOptions& options) {
  Check(packing);
  if (!IsPacking(packing, options.start)) {
    throw std::invalid_argument("start: no packing");
  }
  const SolveDeadline deadline(options);
  PackingChoice best;
  if (packing.fairness == Fairness::kMaxMin) {
    best = SolveMaxMin(packing, options.start, deadline);
  } else {
    best.objective = ComputeObjective(packing, {});
    const PackingTask task{packing};
    AcceptIfBetter(task, options.start, &best);
    AcceptIfBetter(task, PackQuickly(packing, options.start), &best);
    Solve(task, deadline, &best);
  }
  std::sort(best.chosen.begin(), best.chosen.end());
  best.objective = ComputeObjective(packing, best.chosen);
  if (best.optimal) best.bound = best.objective;
  best.min_load = ComputeExtent(AgentLoads(packing, best.chosen)).min_value;
  return best;
}

}  // namespace kg_selector
