#include "kg_selector/path_rules.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <utility>
#include <vector>

#include "kg_core/base/units.h"

namespace kg_selector {
namespace {

using kg_compiler::SeamRules;

struct Unit {
  const char* best;  // The path that needs least.
  const char* name;
  const char* of;  // Behind the budget's unit.
  double size;
};
constexpr Unit kEnergy = {"thriftiest", "Wh", "", kg_core::kJoulesPerWh};
constexpr Unit kHazard = {"safest", "h", " of hazard",
                          kg_core::kSecondsPerHour};

std::string Exceeded(const Unit& unit, double budget, double above) {
  char line[128];
  std::snprintf(line, sizeof line,
                "no path within %.1f %s%s: the %s takes %.1f %s",
                budget / unit.size, unit.name, unit.of, unit.best,
                (budget + above) / unit.size, unit.name);
  return line;
}

}  // namespace

void LimitHazard(const SeamRules& rules, const kg_compiler::NavGraphs& graphs,
                 kg_planner::Trellis* trellis) {
  if (!std::isfinite(rules.hazard_budget_s)) return;
  trellis->more_limits = {rules.hazard_budget_s};
  for (std::size_t s = 0; s < graphs.size(); ++s) {
    std::vector<double> hazard_s;
    for (const kg_compiler::TraverseEdge& edge : graphs[s].edges)
      hazard_s.push_back(edge.flight.hazard_s + edge.isolation_s);
    trellis->stages[s].more_resources = {std::move(hazard_s)};
  }
}

kg_planner::KBest ChoosePaths(const SeamRules& rules,
                              const kg_planner::Trellis& trellis,
                              const kg_planner::Masks& masks) {
  kg_planner::KBestOptions options;
  options.paths = std::max(1, rules.candidates);
  return kg_planner::FindKBest(trellis, masks, options);
}

std::string BudgetNote(const SeamRules& rules, const kg_planner::KBest& found) {
  const std::vector<double>& above = found.above_limits;
  if (!above.empty() && above[0] > 0.0)
    return Exceeded(kEnergy, rules.energy_budget_j, above[0]);
  if (above.size() > 1 && above[1] > 0.0)
    return Exceeded(kHazard, rules.hazard_budget_s, above[1]);
  return "";
}

}  // namespace kg_selector
