#include "kg_selector/paths/path_rules.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <utility>
#include <vector>

#include "kg_base/common/units.h"
#include "kg_planner/k_best/diverse_paths.h"

namespace kg_selector {
namespace {

using kg_compiler::SeamRules;

constexpr int kMaxDecimals = 9;

struct BudgetUnit {
  const char* best;  // Phrase for the path of least use.
  const char* name;
  const char* of;  // Text after the budget's unit.
  double size;
};
constexpr BudgetUnit kEnergy = {"cheapest", "Wh", "", kg_base::kJoulesPerWh};
constexpr BudgetUnit kHazard = {"safest", "h", " of hazard",
                                kg_base::kSecondsPerHour};

std::string Number(double value, int decimals) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

// Formats both with enough decimals to differ.
std::string Exceeded(const BudgetUnit& unit, double budget, double above) {
  const double allowed = budget / unit.size;
  const double taken = (budget + above) / unit.size;
  int decimals = 1;
  while (decimals < kMaxDecimals &&
         Number(allowed, decimals) == Number(taken, decimals)) {
    ++decimals;
  }
  return "no path within " + Number(allowed, decimals) + " " + unit.name +
         unit.of + ": the " + unit.best + " takes " + Number(taken, decimals) +
         " " + unit.name;
}

}  // namespace

void LimitHazard(const SeamRules& rules, const kg_compiler::NavGraphs& graphs,
                 kg_planner::Trellis* trellis) {
  if (!std::isfinite(rules.hazard_budget_s)) return;
  trellis->more_limits = {rules.hazard_budget_s};
  for (std::size_t s = 0; s < graphs.size(); ++s) {
    std::vector<double> hazard_s;
    for (const kg_compiler::TraverseEdge& edge : graphs[s].edges) {
      hazard_s.push_back(edge.flight.hazard_s + edge.isolation_s);
    }
    trellis->stages[s].more_resources = {std::move(hazard_s)};
  }
}

kg_planner::KBest ChoosePaths(const SeamRules& rules,
                              const kg_planner::Trellis& trellis,
                              const kg_planner::PathMasks& masks,
                              kg_planner::KBestMemory* memory) {
  const int paths = std::max(1, rules.candidates);
  if (rules.diverse) {
    kg_planner::DiverseOptions options;
    options.paths = paths;
    options.minimum_difference = rules.minimum_difference;
    return kg_planner::FindDiverse(trellis, masks, options);
  }
  kg_planner::KBestOptions options;
  options.paths = paths;
  return memory ? kg_planner::FindKBest(trellis, masks, options, memory)
                : kg_planner::FindKBest(trellis, masks, options);
}

std::string BudgetNote(const SeamRules& rules, const kg_planner::KBest& found) {
  const std::vector<double>& above = found.above_limits;
  const auto is_to_blame = [&](std::size_t resource) {
    return resource < above.size() && std::isfinite(above[resource]) &&
           above[resource] > 0.0;
  };
  if (is_to_blame(0)) return Exceeded(kEnergy, rules.energy_budget_j, above[0]);
  if (is_to_blame(1)) return Exceeded(kHazard, rules.hazard_budget_s, above[1]);
  return "";
}

}  // namespace kg_selector
