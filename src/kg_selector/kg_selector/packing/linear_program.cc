#include "kg_selector/packing/linear_program.h"

#include <CbcHeuristic.hpp>
#include <CbcModel.hpp>
#include <CglClique.hpp>
#include <CglGomory.hpp>
#include <CglProbing.hpp>
#include <CglZeroHalf.hpp>
#include <OsiClpSolverInterface.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>

namespace kg_selector {
namespace {

// CBC treats this as unlimited [s].
constexpr double kUnlimited_s = 1e9;
// Relative increment by which a solution must be better than the cutoff.
constexpr double kSlack = 1e-9;

// Signs are inverted because the solvers minimise.
void Load(const LinearProgram& program, OsiClpSolverInterface* solver) {
  const int variables = static_cast<int>(program.objective.size());
  const double infinity = solver->getInfinity();
  std::vector<double> low(variables, -infinity);
  std::vector<double> high(variables, infinity);
  std::vector<double> cost(variables);
  for (int j = 0; j < variables; ++j) {
    // Binaries are relaxed to [0, 1]; other variables are free.
    if (j < program.binaries) {
      low[j] = 0.0;
      high[j] = 1.0;
    }
    cost[j] = -program.objective[j];
  }
  // Row-ordered; setDimensions() keeps columns that are in no row.
  CoinPackedMatrix matrix(false, 0, 0);
  matrix.setDimensions(0, variables);
  std::vector<double> row_low(program.rows.size(), -infinity);
  std::vector<double> row_high;
  for (const LinearRow& row : program.rows) {
    CoinPackedVector vector;
    for (const auto& [variable, coefficient] : row.terms) {
      vector.insert(variable, coefficient);
    }
    matrix.appendRow(vector);
    row_high.push_back(row.at_most);
  }
  solver->messageHandler()->setLogLevel(0);
  solver->getModelPtr()->setLogLevel(0);
  solver->loadProblem(matrix, low.data(), high.data(), cost.data(),
                      row_low.data(), row_high.data());
  for (int j = 0; j < program.binaries; ++j) solver->setInteger(j);
}

void AddCuts(CbcModel* model) {
  CglProbing probing;
  probing.setMaxPass(1);
  probing.setMaxProbe(10);
  probing.setMaxLook(50);
  probing.setRowCuts(3);
  CglClique clique;
  clique.setStarCliqueReport(false);
  clique.setRowCliqueReport(false);
  CglZeroHalf zero_half;
  CglGomory gomory;
  gomory.setLimit(100);
  // -1: CBC decides how often each generator is called.
  model->addCutGenerator(&probing, -1, "probing");
  model->addCutGenerator(&clique, -1, "clique");
  model->addCutGenerator(&zero_half, -1, "zero half");
  model->addCutGenerator(&gomory, -1, "gomory");
}

void Limit(const BinaryOptions& options, CbcModel* model) {
  model->setUseElapsedTime(!options.processor_time);
  model->setMaximumSeconds(std::clamp(options.time_limit_s, 0.0, kUnlimited_s));
  model->setDblParam(CbcModel::CbcCutoffIncrement, kSlack);
  if (std::isfinite(options.better_than)) {
    model->setCutoff(-options.better_than -
                     kSlack * (1.0 + std::abs(options.better_than)));
  }
}

}  // namespace

double ClockNow_s(bool processor_time) {
  if (!processor_time) {
    return std::chrono::duration<double>(
               std::chrono::steady_clock::now().time_since_epoch())
        .count();
  }
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * now.tv_nsec;
}

LinearRelaxation Relax(const LinearProgram& program) {
  LinearRelaxation result;
  OsiClpSolverInterface solver;
  Load(program, &solver);
  solver.initialSolve();
  if (!solver.isProvenOptimal()) return result;
  result.solved = true;
  result.value = -solver.getObjValue();
  // Invert signs back to maximisation.
  const int variables = solver.getNumCols();
  const int rows = solver.getNumRows();
  result.values.assign(solver.getColSolution(),
                       solver.getColSolution() + variables);
  for (int j = 0; j < variables; ++j) {
    result.reduced_costs.push_back(-solver.getReducedCost()[j]);
  }
  for (int i = 0; i < rows; ++i) {
    result.row_prices.push_back(std::max(0.0, -solver.getRowPrice()[i]));
  }
  return result;
}

BinarySolution SolveBinary(const LinearProgram& program,
                           const BinaryOptions& options) {
  BinarySolution result;
  OsiClpSolverInterface solver;
  Load(program, &solver);
  CbcModel model(solver);
  model.setLogLevel(0);
  model.messageHandler()->setLogLevel(0);
  AddCuts(&model);
  CbcRounding rounding(model);
  model.addHeuristic(&rounding);
  Limit(options, &model);
  model.initialSolve();
  model.branchAndBound();
  // Status 0: search completed; else a limit was hit.
  result.finished = model.status() == 0;
  result.bound = -model.getBestPossibleObjValue();
  const double* best = model.bestSolution();
  if (best == nullptr) return result;
  for (int j = 0; j < program.binaries; ++j) {
    result.chosen.push_back(best[j] > 0.5);
  }
  return result;
}

}  // namespace kg_selector
